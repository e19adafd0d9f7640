/* values.c - one setting checked and put into a material, each kind of parameter in its way. */
#include "draft.h"

#include "number.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

brdf_status brdf_draft_refuse(const struct brdf_draft *d, brdf_status status, const char *format,
                              ...)
{
    char sentence[700];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    if (d->description && d->setting) {
        return brdf_fail(d->error, status, "\"%.200s\", byte %zu: %s", d->description, d->place + 1,
                         sentence);
    }
    return brdf_fail(d->error, status, "%s: %s", d->model->name, sentence);
}

void brdf_draft_suggest(char *text, size_t size, const char *nearest, const char *known)
{
    if (nearest) {
        snprintf(text, size, "; did you mean \"%s\"?", nearest);
    } else {
        snprintf(text, size, "; known: %s", known);
    }
}

void brdf_draft_list(char *list, size_t size, const char *name)
{
    size_t length = strlen(list);
    snprintf(list + length, size - length, "%s%s", length ? ", " : "", name);
}

const char *brdf_value_refused(const struct brdf_parameter_info *p, const char *name, float value,
                               char *text, size_t size)
{
    char number[BRDF_NUMBER_SIZE], low[BRDF_NUMBER_SIZE], high[BRDF_NUMBER_SIZE];
    char unit[40] = "";
    if (value >= p->low && value <= p->high) { /* a NaN is in no range */
        return NULL;
    }
    brdf_number_write(number, value);
    brdf_number_write(low, p->low);
    brdf_number_write(high, p->high);
    if (strcmp(p->unit, "1") != 0 && strcmp(p->unit, "ior") != 0) { /* the meaning says these */
        snprintf(unit, sizeof unit, " %.32s", p->unit);
    }
    int wants_smooth = value == 0.0f && strncmp(p->name, "alpha", 5) == 0;
    snprintf(text, size, "%.64s = %s is not in its range, %s to %s%s (%s)%s", name, number, low,
             high, unit, p->meaning,
             wants_smooth ? "; smooth surfaces are the models conductor, dielectric and plastic"
                          : "");
    return text;
}

/* Store 1 or 3 numbers. */
static brdf_status store(const struct brdf_draft *d, const struct brdf_parameter_info *p,
                         const float *x, int count)
{
    int place = brdf_parameter_place(d->model, p);
    for (int i = 0; i < count; ++i) {
        char text[400];
        if (brdf_value_refused(p, d->setting->name, x[i], text, sizeof text)) {
            return brdf_draft_refuse(d, BRDF_OUT_OF_RANGE, "%s", text);
        }
        d->bsdf->material.word[place + i] = x[i];
    }
    return BRDF_OK;
}

static brdf_status set_real(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    float x = d->setting->number[0];
    const char *text = d->setting->value;
    if (!text && d->setting->numbers != 1) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s must be one number", p->name);
    }
    if (text && !brdf_number_read(text, &x)) {
        if (strcmp(p->unit, "ior") != 0) {
            return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s must be one number, not \"%.64s\"",
                                     p->name, text);
        }
        const struct brdf_dielectric_substance *dielectric = brdf_dielectric_find(text);
        if (!dielectric) {
            char hint[128];
            brdf_draft_suggest(hint, sizeof hint, brdf_dielectric_nearest(text),
                               "numbers, air, water, bk7, diamond, ...");
            return brdf_draft_refuse(d, BRDF_UNKNOWN_NAME,
                                     "%s: no dielectric is called \"%.64s\"%s", p->name, text,
                                     hint);
        }
        x = dielectric->ior;
    }
    return store(d, p, &x, 1);
}

static brdf_status set_color(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    const struct brdf_setting *setting = d->setting;
    float rgb[3] = {setting->number[0], setting->number[1], setting->number[2]};
    if (!setting->value && setting->numbers == 1) {
        rgb[1] = rgb[2] = rgb[0];
    }
    if (setting->value ? !brdf_color_read(setting->value, rgb)
                       : setting->numbers != 1 && setting->numbers != 3) {
        return brdf_draft_refuse(
            d, BRDF_BAD_ARGUMENT,
            "%s must be one number, three such as 0.2/0.4/0.6, or #rrggbb, not \"%.64s\"", p->name,
            setting->value ? setting->value : "");
    }
    return store(d, p, rgb, 3);
}

/* The text of a setting for a parameter that only a text can set. */
static brdf_status need_text(const struct brdf_draft *d, const char *name, const char *what)
{
    if (d->setting->value) {
        return BRDF_OK;
    }
    return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s must be %s, not a number", name, what);
}

static brdf_status set_choice(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    char options[16][64]; /* 4 bits a choice */
    const char *names[16];
    char known[256] = "", hint[300];
    int count = 0;
    brdf_status status = need_text(d, p->name, "the name of an option");
    if (status) {
        return status;
    }
    while (count < 16 && brdf_parameter_item(p, count, options[count], sizeof options[count])) {
        if (strcmp(options[count], d->setting->value) == 0) {
            int shift = 4 * brdf_parameter_place(d->model, p);
            unsigned *choices = &d->bsdf->material.choices;
            *choices = (*choices & ~(15u << shift)) | (unsigned)count << shift;
            return BRDF_OK;
        }
        brdf_draft_list(known, sizeof known, options[count]);
        names[count] = options[count];
        ++count;
    }
    brdf_draft_suggest(hint, sizeof hint,
                       brdf_name_nearest(d->setting->value, names, (size_t)count), known);
    return brdf_draft_refuse(d, BRDF_UNKNOWN_NAME, "%s has no option \"%.64s\"%s", p->name,
                             d->setting->value, hint);
}

brdf_status brdf_draft_claim(const struct brdf_draft *d, const struct brdf_parameter_info *p,
                             const char *by)
{
    const char **set_by = &d->set_by[p - d->model->parameters];
    if (*set_by) {
        const char *twice = strcmp(*set_by, by) == 0 ? "twice" : "a second time";
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s is set %s (by %s and %s)", p->name,
                                 twice, *set_by, by);
    }
    *set_by = by;
    return BRDF_OK;
}

/* Copy a metal's eta and k, its own values and so not checked against a range. */
brdf_status brdf_draft_put_metal(const struct brdf_draft *d, const struct brdf_metal *metal,
                                 const char *by)
{
    const char *const names[] = {"eta", "k"};
    const float *const values[] = {metal->eta, metal->k};
    for (int i = 0; i < 2; ++i) {
        const struct brdf_parameter_info *p = brdf_parameter_find(d->model, names[i]);
        brdf_status status = brdf_draft_claim(d, p, by);
        if (status) {
            return status;
        }
        memcpy(&d->bsdf->material.word[brdf_parameter_place(d->model, p)], values[i],
               3 * sizeof(float));
    }
    return BRDF_OK;
}

static brdf_status set_metal(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    brdf_status status = need_text(d, p->name, "the symbol of a metal");
    if (status) {
        return status;
    }
    const struct brdf_metal *metal = brdf_metal_find(d->setting->value);
    if (!metal) {
        char known[256] = "", hint[300];
        for (int i = 0; brdf_metal_at(i); ++i) {
            brdf_draft_list(known, sizeof known, brdf_metal_at(i)->name);
        }
        brdf_draft_suggest(hint, sizeof hint, brdf_metal_nearest(d->setting->value), known);
        return brdf_draft_refuse(d, BRDF_UNKNOWN_NAME, "%s: no metal is called \"%.64s\"%s",
                                 p->name, d->setting->value, hint);
    }
    return brdf_draft_put_metal(d, metal, p->name);
}

static brdf_status set_file(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    brdf_status status = need_text(d, p->name, "a path");
    if (status) {
        return status;
    }
    size_t size = strlen(d->setting->value) + 1;
    if (size == 1) {
        return brdf_draft_refuse(d, BRDF_BAD_ARGUMENT, "%s must be a path, and is empty", p->name);
    }
    char *path = malloc(size);
    if (!path) {
        return brdf_draft_refuse(d, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    memcpy(path, d->setting->value, size);
    d->bsdf->file[brdf_file_number(d->model, p)] = path;
    return BRDF_OK;
}

brdf_status brdf_draft_set(const struct brdf_draft *d, const struct brdf_parameter_info *p)
{
    brdf_status status = brdf_draft_claim(d, p, d->setting->name);
    if (status) {
        return status;
    }
    if (d->setting->varies && (p->kind == BRDF_KIND_REAL || p->kind == BRDF_KIND_COLOR)) {
        unsigned words = p->kind == BRDF_KIND_COLOR ? 7u : 1u;
        d->bsdf->varies |= words << brdf_parameter_place(d->model, p);
    }
    switch (p->kind) {
    case BRDF_KIND_CHOICE:
        return set_choice(d, p);
    case BRDF_KIND_REAL:
        return set_real(d, p);
    case BRDF_KIND_COLOR:
        return set_color(d, p);
    case BRDF_KIND_METAL:
        return set_metal(d, p);
    default:
        return set_file(d, p);
    }
}
