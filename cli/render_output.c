/* render_output.c - what a render leaves behind: pictures with metadata, and JSON. */
#include "render.h"

#include <stdio.h>
#include <sys/resource.h>

#include "json.h"
#include "text_file.h"

brdf_status render_outputs_check(const struct render_request *request, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    for (int i = 0; i < request->outputs.count && !status; ++i) {
        status = brdfcl_image_path_check(request->outputs.item[i], error);
    }
    if (!status && request->json) {
        status = text_file_check(request->json, error);
    }
    return status;
}

static struct brdfcl_image_metadata text_entry(const char *name, const char *text)
{
    struct brdfcl_image_metadata entry;
    entry.name = name;
    entry.kind = BRDFCL_METADATA_TEXT;
    entry.value.text = text;
    return entry;
}

static struct brdfcl_image_metadata int_entry(const char *name, int value)
{
    struct brdfcl_image_metadata entry;
    entry.name = name;
    entry.kind = BRDFCL_METADATA_INT;
    entry.value.integer = value;
    return entry;
}

static struct brdfcl_image_metadata float_entry(const char *name, double value)
{
    struct brdfcl_image_metadata entry;
    entry.name = name;
    entry.kind = BRDFCL_METADATA_FLOAT;
    entry.value.number = (float)value;
    return entry;
}

static brdf_status write_pictures(const struct render_request *request,
                                  const struct render_outcome *outcome, struct brdf_error *error)
{
    const struct brdfcl_image_metadata metadata[] = {
        text_entry("software", "brdfcl " BRDFCL_VERSION),
        text_entry("scene", request->scene_path),
        int_entry("spp", outcome->result.spp),
        int_entry("seed", outcome->scene.seed),
        int_entry("depth", outcome->scene.max_depth),
        text_entry("device", outcome->device),
        int_entry("lanes", outcome->lanes),
        float_entry("renderSeconds", outcome->result.seconds_render),
    };
    struct brdfcl_image_options options = {0, (float)request->exposure, metadata,
                                           (int)(sizeof metadata / sizeof metadata[0])};
    options.half = request->half == HALF_OF_SCENE ? outcome->scene.half : request->half;
    brdf_status status = BRDF_OK;
    for (int i = 0; i < request->outputs.count && !status; ++i) {
        status =
            brdfcl_image_write(&outcome->result.image, request->outputs.item[i], &options, error);
    }
    return status;
}

static void put_mean(struct json *json, const struct brdfcl_image *image)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    json_array(json, "mean");
    for (size_t channel = 0; channel < 3; ++channel) {
        double sum = 0.0;
        for (size_t i = 0; i < pixels; ++i) {
            sum += (double)image->rgb[3 * i + channel];
        }
        json_real(json, NULL, sum / (double)pixels);
    }
    json_array_end(json);
}

static long long peak_rss_bytes(void)
{
    struct rusage usage;
    if (getrusage(RUSAGE_SELF, &usage)) {
        return 0;
    }
#ifdef __APPLE__
    return usage.ru_maxrss;
#else
    return (long long)usage.ru_maxrss * 1024;
#endif
}

static brdf_status write_json(const struct render_request *request,
                              const struct render_outcome *outcome, struct brdf_error *error)
{
    const struct brdfcl_render_result *result = &outcome->result;
    double seconds = result->seconds_render;
    char hash[32];
    snprintf(hash, sizeof hash, "0x%016llx", brdfcl_image_hash(&result->image));

    struct json json = {0};
    json_object(&json, NULL);
    json_text(&json, "scene", request->scene_path);
    json_int(&json, "width", result->image.width);
    json_int(&json, "height", result->image.height);
    json_int(&json, "spp", result->spp);
    json_int(&json, "depth", outcome->scene.max_depth);
    json_int(&json, "seed", outcome->scene.seed);
    json_text(&json, "backend", request->backend.kind == BACKEND_C ? "c" : "opencl");
    json_text(&json, "device", outcome->device);
    json_int(&json, "lanes", outcome->lanes);
    json_real(&json, "seconds_kernel_build", result->seconds_kernel_build);
    json_real(&json, "seconds_render", seconds);
    json_real(&json, "samples_per_second", seconds > 0.0 ? (double)result->samples / seconds : 0.0);
    json_int(&json, "rays", result->rays);
    json_int(&json, "peak_rss_bytes", peak_rss_bytes());
    put_mean(&json, &result->image);
    json_text(&json, "image_hash", hash);
    json_object_end(&json);
    brdf_status status = json_write(&json, request->json, error);
    json_free(&json);
    return status;
}

brdf_status render_outputs_write(const struct render_request *request,
                                 const struct render_outcome *outcome, struct brdf_error *error)
{
    brdf_status status = write_pictures(request, outcome, error);
    if (!status && request->json) {
        status = write_json(request, outcome, error);
    }
    return status;
}
