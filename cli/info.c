/* info.c - brdfcl info: what a measured file holds, and how far it is to be trusted. */
#include <stdio.h>
#include <string.h>

#include "brdflab/open.h"
#include "brdflab/survey.h"
#include "commands.h"
#include "json.h"
#include "measured.h"
#include "options.h"
#include "say.h"
#include "text_file.h"

static const char summary[] =
    "Describe a measured material, a .binary or .bsdf file: its format and size, how much of it "
    "was\n"
    "measured, least and largest values, albedo over angles, whether it is reciprocal, whether it\n"
    "reflects more than it receives, and where it is to be doubted.";

struct info_run {
    const char *path;
    const char *json_path;
    int fill;
    enum lab_format format;
    struct lab_survey survey;
    struct lab_merl_survey merl; /* if that is the format */
    struct lab_rgl_survey rgl;
};

static brdf_status survey_rgl(struct info_run *run, const struct brdf_bsdf *bsdf,
                              struct brdf_error *error)
{
    struct brdf_rgl_file file;
    brdf_status status = brdf_rgl_read(run->path, &file, error);
    if (!status) {
        lab_survey_rgl(&file, bsdf, &run->rgl);
        brdf_rgl_free(&file);
    }
    return status;
}

static brdf_status survey_merl(struct info_run *run, struct brdf_error *error)
{
    struct brdf_merl_file file;
    brdf_status status = brdf_merl_read(run->path, BRDF_MERL_INVALID_KEEP, &file, error);
    if (!status) {
        lab_survey_merl(&file, &run->merl);
        brdf_merl_free(&file);
    }
    return status;
}

static brdf_status survey(struct info_run *run, struct brdf_error *error)
{
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = lab_open_filled(run->path, run->fill, &bsdf, &run->format, error);
    if (!status && run->format == LAB_FORMAT_MERL) {
        status = survey_merl(run, error);
    } else if (!status && run->format == LAB_FORMAT_RGL) {
        status = survey_rgl(run, bsdf, error);
    }
    if (!status) {
        lab_survey_make(bsdf, &run->survey);
    }
    brdf_bsdf_destroy(bsdf);
    return status;
}

static const char *doubt(const struct info_run *run, int number, char *text, size_t size)
{
    struct lab_findings findings = {&run->survey,
                                    run->format == LAB_FORMAT_MERL ? &run->merl : NULL,
                                    run->format == LAB_FORMAT_RGL ? &run->rgl : NULL, run->fill};
    return lab_survey_doubt(&findings, number, text, size);
}

static void print_place(const char *name, double value, struct lab_place at)
{
    printf("%-12s%.5g 1/sr, at theta_h %.2f, theta_d %.1f, phi_d %.1f degrees\n", name, value,
           at.theta_h, at.theta_d, at.phi_d);
}

static void print_merl(const struct lab_merl_survey *m)
{
    printf("format      MERL: isotropic, 90 x 90 x %d bins of theta_h, theta_d, phi_d, RGB\n",
           m->folded ? 360 : 180);
    if (m->folded) {
        printf("folded      to 180 bins of phi_d: opposite ones, which differ by %.2g of f on "
               "average, "
               "are one\n",
               m->folding);
    }
    printf("measured    %zu of %zu bins (%.1f %%); of the %zu above the surface all but %zu\n",
           m->valid, m->bins, 100.0 * (double)m->valid / (double)m->bins, m->above,
           m->above_invalid);
    print_place("least f", m->least, m->least_at);
    print_place("largest f", m->most, m->most_at);
    printf("noise       %.2g of f between neighbours, %.2g beyond 60 degrees\n", m->noise,
           m->noise_grazing);
}

static void print_pair(const char *name, double value, struct lab_pair at)
{
    printf("%-12s%.5g 1/sr, at wo %.1f, wi %.1f degrees from the normal, %.0f apart around it\n",
           name, value, at.theta_o, at.theta_i, at.phi);
}

static void print_rgl(const struct lab_rgl_survey *r)
{
    printf("format      RGL: %s, %s\n", r->phis <= 2 ? "isotropic" : "anisotropic",
           r->spectral ? "spectral" : "RGB");
    printf("measured    %d x %d views (azimuths, polar angles up to %.1f degrees), each %d x %d, "
           "%d %s\n",
           r->phis, r->thetas, r->theta_most, r->size, r->size, r->channels,
           r->spectral ? "wavelengths" : "channels");
    printf("valid       %.1f %% of the values, the others are below 0\n",
           100.0 * (1.0 - r->negative));
    print_pair("least f", r->least, r->least_at);
    print_pair("largest f", r->most, r->most_at);
}

static void print_survey(const struct lab_survey *s, enum lab_format format)
{
    printf("albedo      %7s  %7s %7s %7s\n", "theta", "red", "green", "blue");
    for (int k = 0; k < LAB_SURVEY_ANGLES; ++k) {
        printf("            %7g  %7.4f %7.4f %7.4f\n", lab_survey_angles[k], s->albedo[k][0],
               s->albedo[k][1], s->albedo[k][2]);
    }
    printf("            %7s  %7.4f %7.4f %7.4f\n", "average", s->albedo_diffuse[0],
           s->albedo_diffuse[1], s->albedo_diffuse[2]);
    printf("reciprocity f(wo, wi) and f(wi, wo) differ by %.2g of f on average%s\n", s->reciprocity,
           format == LAB_FORMAT_MERL ? ": MERL stores them as one" : "");
    if (s->energy_from < 90.0) {
        printf("energy      albedo up to %.4f (%g degrees), above 1 from %g degrees on\n",
               s->energy, s->energy_angle, s->energy_from);
    } else {
        printf("energy      albedo up to %.4f (%g degrees), never above 1\n", s->energy,
               s->energy_angle);
    }
}

static void print(const struct info_run *run)
{
    char text[300];
    printf("%s\n", run->path);
    if (run->format == LAB_FORMAT_MERL) {
        print_merl(&run->merl);
    } else if (run->format == LAB_FORMAT_RGL) {
        print_rgl(&run->rgl);
    } else {
        printf("format      a description, not a file\n");
    }
    print_survey(&run->survey, run->format);
    for (int i = 0; doubt(run, i, text, sizeof text); ++i) {
        printf("doubt       %s\n", text);
    }
}

static void put_color(struct json *json, const char *key, const double color[3])
{
    json_array(json, key);
    for (int channel = 0; channel < 3; ++channel) {
        json_real(json, NULL, color[channel]);
    }
    json_array_end(json);
}

static void put_place(struct json *json, const char *key, double value, struct lab_place at)
{
    json_object(json, key);
    json_real(json, "value", value);
    json_real(json, "theta_h", at.theta_h);
    json_real(json, "theta_d", at.theta_d);
    json_real(json, "phi_d", at.phi_d);
    json_object_end(json);
}

static void put_merl(struct json *json, const struct lab_merl_survey *m)
{
    json_array(json, "bins");
    json_int(json, NULL, 90);
    json_int(json, NULL, 90);
    json_int(json, NULL, m->folded ? 360 : 180);
    json_array_end(json);
    json_int(json, "folded", m->folded);
    json_real(json, "folding", m->folding);
    json_int(json, "valid", (long long)m->valid);
    json_real(json, "valid_fraction", (double)m->valid / (double)m->bins);
    json_int(json, "above", (long long)m->above);
    json_int(json, "above_invalid", (long long)m->above_invalid);
    json_int(json, "zero", (long long)m->zero);
    put_place(json, "least", m->least, m->least_at);
    put_place(json, "largest", m->most, m->most_at);
    json_real(json, "noise", m->noise);
    json_real(json, "noise_grazing", m->noise_grazing);
}

static void put_pair(struct json *json, const char *key, double value, struct lab_pair at)
{
    json_object(json, key);
    json_real(json, "value", value);
    json_real(json, "theta_o", at.theta_o);
    json_real(json, "theta_i", at.theta_i);
    json_real(json, "phi", at.phi);
    json_object_end(json);
}

static void put_rgl(struct json *json, const struct lab_rgl_survey *r)
{
    json_int(json, "azimuths", r->phis);
    json_int(json, "polar_angles", r->thetas);
    json_real(json, "polar_angle_most", r->theta_most);
    json_int(json, "size", r->size);
    json_int(json, "channels", r->channels);
    json_int(json, "spectral", r->spectral);
    json_real(json, "valid_fraction", 1.0 - r->negative);
    put_pair(json, "least", r->least, r->least_at);
    put_pair(json, "largest", r->most, r->most_at);
}

static void put_survey(struct json *json, const struct lab_survey *s)
{
    json_array(json, "albedo");
    for (int k = 0; k < LAB_SURVEY_ANGLES; ++k) {
        json_object(json, NULL);
        json_real(json, "theta", lab_survey_angles[k]);
        put_color(json, "reflection", s->albedo[k]);
        json_object_end(json);
    }
    json_array_end(json);
    json_object(json, "albedo_average");
    put_color(json, "reflection", s->albedo_diffuse);
    json_object_end(json);
    json_real(json, "reciprocity", s->reciprocity);
    json_real(json, "energy", s->energy);
    json_real(json, "energy_theta", s->energy_angle);
}

static brdf_status write_json(const struct info_run *run, struct brdf_error *error)
{
    static const char *const names[] = {"description", "merl", "rgl"};
    struct json json = {0};
    char text[300];
    json_object(&json, NULL);
    json_text(&json, "material", run->path);
    json_text(&json, "format", names[run->format]);
    if (run->format == LAB_FORMAT_MERL) {
        put_merl(&json, &run->merl);
    } else if (run->format == LAB_FORMAT_RGL) {
        put_rgl(&json, &run->rgl);
    }
    put_survey(&json, &run->survey);
    json_array(&json, "doubts");
    for (int i = 0; doubt(run, i, text, sizeof text); ++i) {
        json_text(&json, NULL, text);
    }
    json_array_end(&json);
    json_object_end(&json);
    brdf_status status = json_write(&json, run->json_path, error);
    json_free(&json);
    return status;
}

int command_info(int argc, char **argv)
{
    struct info_run run = {.fill = 1};
    struct brdf_error error = {BRDF_OK, ""};
    const struct option options[] = {
        {"json", 0, OPTION_TEXT, &run.json_path, "FILE", 0, 0,
         "write it as JSON instead; - is standard output"},
        MEASURED_NO_FILL(&run.fill),
    };
    const struct usage usage = {
        "info", "MATERIAL", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int exit_status = options_read(&usage, argc, argv, &arguments);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    run.path = arguments.item[0];
    brdf_status status = run.json_path ? text_file_check(run.json_path, &error) : BRDF_OK;
    status = status ? status : survey(&run, &error);
    if (!status && run.json_path) {
        status = write_json(&run, &error);
    } else if (!status) {
        print(&run);
    }
    return status ? say_error(&error) : EXIT_DONE;
}
