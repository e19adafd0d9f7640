/* render.c - brdfcl render: a scene in, pictures out. */
#include "render.h"

#include <stdio.h>
#include <string.h>

#include "commands.h"
#include "file_name.h"
#include "progress.h"
#include "say.h"
#include "stop.h"

static const char summary[] = "Render a scene (Mitsuba 3 XML). The suffix of each -o chooses its "
                              "format: .exr (linear, with the\n"
                              "settings as metadata) or .png (sRGB). Without -o the picture goes "
                              "to the current folder, under\n"
                              "the scene's name with .exr. Ctrl-C saves what has been rendered so "
                              "far; twice, it quits at once.";

/* Read the command line; an exit status, or OPTIONS_GO_ON. */
static int read_request(struct render_request *request, int argc, char **argv)
{
    struct backend *backend = &request->backend;
    const struct option options[] = {
        {NULL, 'o', OPTION_LIST, &request->outputs, "FILE", 0, 0,
         "write the picture here (.exr, .png); several are fine"},
        {"spp", 0, OPTION_INT, &request->spp, "N", 1, 1 << 24, "samples for each pixel"},
        {"depth", 0, OPTION_INT, &request->depth, "N", -1, 1 << 24,
         "segments of a path at most; -1: no limit"},
        {"size", 0, OPTION_SIZE, &request->size, "WxH", 1, 65536, "pixels of the picture"},
        {"seed", 0, OPTION_INT, &request->seed, "N", 0, 2147483647, "another seed, other noise"},
        {"backend", 0, OPTION_CHOICE, &backend->kind, BACKEND_NAMES, 0, 0,
         "where to compute; both give the same picture"},
        {"device", 0, OPTION_TEXT, &backend->device, "D", 0, 0,
         "OpenCL device: its number or a part of its name"},
        {"lanes", 0, OPTION_INT, &backend->lanes, "N", 1, 16,
         "vector lanes of kernels: 1, 4, 8, 16"},
        {"threads", 0, OPTION_INT, &backend->threads, "N", 1, 4096,
         "cores to use; all if not given"},
        {NULL, 'D', OPTION_LIST, &request->defines, "NAME=VALUE", 0, 0,
         "set a $NAME of the scene; several are fine"},
        {"exposure", 0, OPTION_REAL, &request->exposure, "EV", -100, 100,
         "stops that a PNG is made brighter by"},
        {"half", 0, OPTION_ON, &request->half, NULL, 0, 0, "OpenEXR of 16-bit floats"},
        {"float", 0, OPTION_OFF, &request->half, NULL, 0, 0,
         "OpenEXR of 32-bit floats; else as the scene says"},
        {"json", 0, OPTION_TEXT, &request->json, "FILE", 0, 0,
         "write settings, times and the picture's hash; - is standard output"},
        {"quiet", 0, OPTION_ON, &request->quiet, NULL, 0, 0, "say nothing unless it fails"},
    };
    const struct usage usage = {
        "render", "SCENE.xml", summary, options, sizeof options / sizeof options[0], 1, 1};
    struct texts arguments;
    int status = options_read(&usage, argc, argv, &arguments);
    if (status == OPTIONS_GO_ON) {
        request->scene_path = arguments.item[0];
        status = backend_check(backend);
    }
    return status;
}

/* The scene's name without folders and .xml, with .exr, in the current folder. */
static void choose_output(struct render_request *request)
{
    const char *name = file_name_of(request->scene_path);
    size_t length = strlen(name);
    if (request->outputs.count) {
        return;
    }
    if (length > 4 && strcmp(name + length - 4, ".xml") == 0) {
        length -= 4;
    }
    snprintf(request->default_output, sizeof request->default_output, "%.*s.exr",
             (int)(length < 1000 ? length : 1000), name);
    request->outputs.item[request->outputs.count++] = request->default_output;
}

static brdf_status load_scene(const struct render_request *request, struct brdfcl_scene **scene,
                              struct brdf_error *error)
{
    struct brdfcl_define defines[64];
    char names[64][64];
    size_t count = (size_t)request->defines.count;
    for (size_t i = 0; i < count; ++i) {
        const char *text = request->defines.item[i];
        size_t length = strcspn(text, "=");
        if (!text[length] || length == 0 || length >= sizeof names[i]) {
            return brdf_fail(error, BRDF_BAD_ARGUMENT, "-D \"%s\": expected NAME=VALUE", text);
        }
        memcpy(names[i], text, length);
        names[i][length] = '\0';
        defines[i].name = names[i];
        defines[i].value = text + length + 1;
    }
    brdf_status status = brdfcl_scene_load(request->scene_path, defines, count, scene, error);
    if (!status && request->size.width) {
        status = brdfcl_scene_set_size(*scene, request->size.width, request->size.height, error);
    }
    if (!status && request->spp) {
        status = brdfcl_scene_set_spp(*scene, request->spp, error);
    }
    if (!status && request->depth != DEPTH_OF_SCENE) {
        status = brdfcl_scene_set_depth(*scene, request->depth, error);
    }
    if (!status && request->seed >= 0) {
        brdfcl_scene_set_seed(*scene, request->seed);
    }
    return status;
}

static int on_progress(void *context, const struct brdfcl_progress *state)
{
    stop_set_phase(STOP_ASKS); /* from now on there is something to save */
    progress_show(context, state);
    return stop_signal() != 0;
}

static brdf_status trace(const struct render_request *request, const struct brdfcl_scene *scene,
                         struct brdfcl_device *device, struct brdfcl_render_result *result,
                         struct brdf_error *error)
{
    struct progress progress = progress_begin(request->quiet);
    struct brdfcl_render_options options = {0};
    options.device = device;
    options.threads = request->backend.threads;
    options.progress = on_progress;
    options.context = &progress;
    brdf_status status = brdfcl_render(scene, &options, result, error);
    stop_set_phase(STOP_WAITS);
    progress_end(&progress);
    return status;
}

static void tell(const struct render_request *request, const struct render_outcome *outcome)
{
    const struct brdfcl_render_result *result = &outcome->result;
    char seconds[32], rate[16];
    if (result->invalid) {
        say("%lld samples were not finite and count as black; please report this scene",
            result->invalid);
    }
    if (result->stopped && result->spp == 0) {
        say("stopped before every pixel had a sample: the rest of the picture is black; saved");
    } else if (result->stopped) {
        say("stopped with %d of %d samples for each pixel; saved", result->spp, outcome->scene.spp);
    }
    if (request->quiet) {
        return;
    }
    double per_second =
        result->seconds_render > 0.0 ? (double)result->samples / result->seconds_render : 0.0;
    for (int i = 0; i < request->outputs.count; ++i) {
        fprintf(stderr, "%s: ", request->outputs.item[i]);
        fprintf(stderr, "%d x %d, %d samples for each pixel\n", result->image.width,
                result->image.height, result->spp);
    }
    fprintf(stderr, "%s on %s", short_time(result->seconds_render, seconds), outcome->device);
    if (request->backend.kind == BACKEND_OPENCL) {
        fprintf(stderr, ", %d lanes", outcome->lanes);
    }
    fprintf(stderr, ", %s samples/s; ready after %s\n", short_number(per_second, rate),
            short_time(result->seconds_kernel_build, seconds));
}

static brdf_status run(const struct render_request *request, struct brdf_error *error)
{
    struct brdfcl_scene *scene = NULL;
    struct brdfcl_device *device = NULL;
    struct brdfcl_device_info info;
    struct render_outcome outcome;
    memset(&outcome, 0, sizeof outcome);
    brdf_status status = render_outputs_check(request, error);
    if (!status) {
        status = load_scene(request, &scene, error);
    }
    if (!status) {
        status = backend_open(&request->backend, &device, error);
    }
    if (status) {
        goto done;
    }
    const char *note;
    for (size_t i = 0; !request->quiet && (note = brdfcl_scene_note(scene, i)) != NULL; ++i) {
        say("note: %s", note);
    }
    outcome.device = "C";
    outcome.lanes = 1;
    if (device) {
        info = brdfcl_device_get_info(device);
        outcome.device = info.name;
        outcome.lanes = brdfcl_device_lanes(device);
    }
    outcome.scene = brdfcl_scene_get_info(scene);
    status = trace(request, scene, device, &outcome.result, error);
    if (!status) {
        status = render_outputs_write(request, &outcome, error);
    }
    if (!status) {
        tell(request, &outcome);
    }
done:
    brdfcl_image_destroy(&outcome.result.image);
    brdfcl_device_close(device);
    brdfcl_scene_destroy(scene);
    return status;
}

int command_render(int argc, char **argv)
{
    struct render_request request;
    memset(&request, 0, sizeof request);
    request.depth = DEPTH_OF_SCENE;
    request.half = HALF_OF_SCENE;
    request.seed = -1;
    int exit_status = read_request(&request, argc, argv);
    if (exit_status != OPTIONS_GO_ON) {
        return exit_status;
    }
    choose_output(&request);
    stop_install();
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = run(&request, &error);
    if (status == BRDF_CANCELLED) {
        say("stopped before every pixel had a sample: nothing to save");
    } else if (status) {
        return say_error(&error);
    }
    return stop_signal() ? 128 + stop_signal() : EXIT_DONE;
}
