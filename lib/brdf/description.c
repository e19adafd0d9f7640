/* description.c - a bsdf from one line of text, and back. */
#include "bsdf.h"

#include "number.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char spaces[] = " \t\r\n";

/* A description cut into names and values, in a copy of its text. */
struct reader {
    const char *description;
    char *text;
    char *next;
    struct brdf_setting *settings;
    size_t *places;
    size_t count;
    struct brdf_error *error;
};

static brdf_status refuse(const struct reader *r, const char *at, const char *sentence)
{
    return brdf_fail(r->error, BRDF_BAD_ARGUMENT, "\"%.200s\", byte %zu: %s", r->description,
                     (size_t)(at - r->text) + 1, sentence);
}

/* End the text before `end` and the spaces before that. */
static void end_text(char *start, char *end)
{
    while (end > start && strchr(spaces, end[-1])) {
        --end;
    }
    *end = '\0';
}

/* A value in double quotes, unquoted in its place; r->next stands on the first quote. */
static brdf_status read_quoted(struct reader *r, const char **value)
{
    char *from = r->next + 1, *to = r->next;
    *value = to;
    while (*from != '\0' && (from[0] != '"' || from[1] == '"')) {
        from += *from == '"';
        *to++ = *from++;
    }
    if (*from == '\0') {
        return refuse(r, r->next, "a quote is not closed");
    }
    char *after = from + 1 + strspn(from + 1, spaces);
    if (*after != '\0' && *after != ',') {
        return refuse(r, after, "a comma must follow the closing quote");
    }
    *to = '\0';
    r->next = after + (*after == ',');
    return BRDF_OK;
}

/* NAME=VALUE, or NAME alone for "true", up to the next comma or the end. */
static brdf_status read_setting(struct reader *r)
{
    struct brdf_setting *setting = &r->settings[r->count];
    char *name = r->next + strspn(r->next, spaces);
    char *end = name + strcspn(name, "=,");
    char mark = *end;
    if (end == name) {
        return refuse(r, name, "a setting (name=value) is missing");
    }
    r->places[r->count++] = (size_t)(name - r->text);
    *setting = brdf_setting_text(name, "true");
    end_text(name, end);
    r->next = end + (mark != '\0');
    if (mark == '=') {
        char *value = r->next + strspn(r->next, spaces);
        r->next = value;
        if (*value == '"') {
            return read_quoted(r, &setting->value);
        }
        setting->value = value;
        end = value + strcspn(value, ",");
        mark = *end;
        end_text(value, end);
        r->next = end + (mark != '\0');
    } else if (strcmp(name, "twosided") != 0) {
        return refuse(r, name, "a value is missing: write name=value");
    }
    return BRDF_OK;
}

/* All settings after the colon; a comma promises one more. */
static brdf_status read_settings(struct reader *r)
{
    brdf_status status = BRDF_OK;
    const char *last = r->text + strlen(r->description);
    int more = 1;
    while (!status && more) {
        status = read_setting(r);
        more = r->next < last || (r->next == last && r->description[last - r->text - 1] == ',');
    }
    return status;
}

/* The copy, and room for as many settings as there can be. */
static brdf_status reader_create(struct reader *r, const char *description)
{
    size_t length = strlen(description), most = 1;
    for (const char *c = description; *c != '\0'; ++c) {
        most += *c == ',';
    }
    r->description = description;
    r->text = malloc(length + 1);
    r->settings = malloc(most * sizeof *r->settings);
    r->places = malloc(most * sizeof *r->places);
    if (!r->text || !r->settings || !r->places) {
        return brdf_fail(r->error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    memcpy(r->text, description, length + 1);
    return BRDF_OK;
}

brdf_status brdf_bsdf_create(const char *description, struct brdf_bsdf **out,
                             struct brdf_error *error)
{
    struct reader r = {0};
    r.error = error;
    *out = NULL;
    brdf_status status = reader_create(&r, description);
    if (status) {
        goto done;
    }
    char *model = r.text + strspn(r.text, spaces);
    char *end = model + strcspn(model, ":");
    int settings = *end == ':';
    end_text(model, end);
    r.next = end + settings;
    if (settings) {
        status = read_settings(&r);
    }
    if (!status) {
        struct brdf_origin origin = {description, r.places};
        status = brdf_bsdf_build(model, r.settings, r.count, &origin, 0, out, error);
    }
done:
    free(r.text);
    free(r.settings);
    free(r.places);
    return status;
}

/* Text that is counted even where there is no room for it. */
struct writer {
    char *text;
    size_t size;
    size_t length;
};

static void put(struct writer *w, const char *text)
{
    for (; *text != '\0'; ++text, ++w->length) {
        if (w->length + 1 < w->size) {
            w->text[w->length] = *text;
        }
    }
}

static void put_quoted(struct writer *w, const char *text)
{
    put(w, "\"");
    for (; *text != '\0'; ++text) {
        char one[] = {*text, '\0'};
        put(w, *text == '"' ? "\"\"" : one);
    }
    put(w, "\"");
}

static void put_number(struct writer *w, float x)
{
    char number[BRDF_NUMBER_SIZE];
    brdf_number_write(number, x);
    put(w, number);
}

/* Three numbers, or one where they are the same. */
static void put_color(struct writer *w, const float rgb[3])
{
    /* Each the same as the next. */
    int gray = memcmp(&rgb[0], &rgb[1], 2 * sizeof *rgb) == 0;
    put_number(w, rgb[0]);
    for (int i = 1; i < 3 && !gray; ++i) {
        put(w, "/");
        put_number(w, rgb[i]);
    }
}

static void put_value(struct writer *w, const struct brdf_bsdf *bsdf,
                      const struct brdf_model_info *model, const struct brdf_parameter_info *p)
{
    int place = brdf_parameter_place(model, p);
    char option[64];
    switch (p->kind) {
    case BRDF_KIND_CHOICE:
        brdf_parameter_item(p, (int)(bsdf->material.choices >> (4 * place) & 15u), option,
                            sizeof option);
        put(w, option);
        break;
    case BRDF_KIND_REAL:
        put_number(w, bsdf->material.word[place]);
        break;
    case BRDF_KIND_COLOR:
        put_color(w, &bsdf->material.word[place]);
        break;
    default:
        put_quoted(w, bsdf->file[brdf_file_number(model, p)]);
        break;
    }
}

size_t brdf_bsdf_describe(const struct brdf_bsdf *bsdf, char *text, size_t size)
{
    const struct brdf_model_info *model = brdf_model_info((int)bsdf->material.model);
    struct writer w = {text, size, 0};
    const char *mark = ":";
    put(&w, model->name);
    for (size_t i = 0; i < model->parameter_count; ++i) {
        const struct brdf_parameter_info *p = &model->parameters[i];
        if (p->kind != BRDF_KIND_ALIAS && p->kind != BRDF_KIND_METAL) {
            put(&w, mark);
            put(&w, p->name);
            put(&w, "=");
            put_value(&w, bsdf, model, p);
            mark = ",";
        }
    }
    if (bsdf->material.flags & BRDF_TWOSIDED) {
        put(&w, mark);
        put(&w, "twosided");
    }
    if (size > 0) {
        text[w.length < size ? w.length : size - 1] = '\0';
    }
    return w.length;
}
