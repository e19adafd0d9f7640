/* edit.c - brdfcl edit: a measured material with another highlight, diffuse part or colour. */
#include <stdio.h>
#include <string.h>

#include "brdflab/edit.h"
#include "angle.h"
#include "brdflab/open.h"
#include "commands.h"
#include "measured.h"
#include "options.h"

static const char summary[] =
    "Change a material and write it as a measured file. The diffuse part is what f falls to far "
    "from\n"
    "the highlight, by the angle of difference and the colour; the highlight is the rest. Its "
    "width\n"
    "changes in the slopes of the half vector and keeps its energy. Hue and saturation change in "
    "Oklab,\n"
    "and keep lightness. What is not given stays as it is.";

struct edit_run {
    const char *in;
    struct measured_out out;
    int fill;
    struct lab_edit edit;
    int part;               /* enum lab_edit_part */
    enum lab_format format; /* of what is edited */
};

static int read_command_line(struct edit_run *run, int argc, char **argv)
{
    struct lab_edit *edit = &run->edit;
    const struct option options[] = {
        {"gloss", 0, OPTION_REAL, &edit->gloss, "FACTOR", 0.05, 20,
         "the highlight gets so many times narrower; below 1 wider"},
        {"specular", 0, OPTION_REAL, &edit->specular, "FACTOR", 0, 1000, "on the highlight"},
        {"diffuse", 0, OPTION_REAL, &edit->diffuse, "FACTOR", 0, 1000, "on the diffuse part"},
        {"hue", 0, OPTION_REAL, &edit->hue, "DEGREES", -360, 360,
         "turn it: 30 makes red orange, and orange yellow"},
        {"saturation", 0, OPTION_REAL, &edit->saturation, "FACTOR", 0, 100,
         "on the chroma; 0 is gray"},
        {"part", 0, OPTION_CHOICE, &run->part, "all|diffuse|specular", 0, 0,
         "whose hue and saturation change; all if not given"},
        {"metal", 0, OPTION_ON, &edit->metal, NULL, 0, 0,
         "there is no diffuse part: all of it is highlight"},
        MEASURED_OUT_OPTIONS(run->out),
        MEASURED_NO_FILL(&run->fill),
    };
    const struct usage usage = {
        "edit", "MATERIAL OUT", summary, options, sizeof options / sizeof options[0], 2, 2};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status != OPTIONS_GO_ON) {
        return status;
    }
    run->in = arguments.item[0];
    edit->hue *= degree;
    edit->part = (enum lab_edit_part)run->part;
    return measured_out_set(&run->out, arguments.item[1], arguments.item, 1);
}

/* A file that would be written again as it is. */
static int is_copy(const struct edit_run *run)
{
    return lab_edit_is_nothing(&run->edit) && (int)run->format == run->out.format && run->fill;
}

static brdf_status edit_and_write(struct edit_run *run, struct brdf_error *error)
{
    struct brdf_merl_file file = {0}, edited = {0};
    brdf_status status = measured_check(&run->out, error);
    status = status ? status : lab_format_of(run->in, &run->format, error);
    if (status) {
        return status;
    }
    if (is_copy(run)) {
        struct brdf_bsdf *bsdf; /* what is copied is to be a measured file */
        status = lab_open(run->in, &bsdf, NULL, error);
        brdf_bsdf_destroy(bsdf);
        return status ? status : measured_copy(&run->out, run->in, error);
    }
    status = measured_open(run->in, run->fill, &file, &run->format, error);
    status = status ? status : lab_edit_merl(&file, &run->edit, &edited, error);
    status = status ? status : measured_write(&run->out, &edited, error);
    brdf_merl_free(&edited);
    brdf_merl_free(&file);
    return status;
}

/* What became of the material. */
static const char *outcome(const struct edit_run *run)
{
    if (!lab_edit_is_nothing(&run->edit)) {
        return "edited";
    }
    return is_copy(run) ? "unchanged" : "converted, and not edited";
}

int command_edit(int argc, char **argv)
{
    struct edit_run run = {.edit = lab_edit_nothing(), .fill = 1};
    struct brdf_error error = {BRDF_OK, ""};
    int exit_status = read_command_line(&run, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    brdf_status status = edit_and_write(&run, &error);
    if (!status) {
        printf("%s: %s, %s\n", run.out.path, run.in, outcome(&run));
    }
    return measured_exit(status, &error);
}
