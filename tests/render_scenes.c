/* render_scenes.c - scenes loaded, rendered, averaged. */
#include "render_scenes.h"

#include <math.h>

static const char *text_or(const char *text, const char *otherwise)
{
    return text ? text : otherwise;
}

static int int_or(int number, int otherwise)
{
    return number ? number : otherwise;
}

struct brdfcl_scene *render_scene_load(const struct view *view, const char *content)
{
    const char *frame =
        "<scene version=\"3.0.0\">\n<integrator type=\"path\">"
        "<integer name=\"max_depth\" value=\"%d\"/><integer name=\"rr_depth\" value=\"%d\"/>"
        "</integrator>\n<sensor type=\"perspective\"><float name=\"fov\" value=\"%g\"/>"
        "<transform name=\"to_world\"><lookat origin=\"%s\" target=\"%s\" up=\"0.2, 1, 0.1\"/>"
        "</transform>\n<sampler type=\"%s\"><integer name=\"sample_count\" value=\"%d\"/></sampler>"
        "<film type=\"hdrfilm\"><integer name=\"width\" value=\"%d\"/>"
        "<integer name=\"height\" value=\"%d\"/><rfilter type=\"%s\"/></film></sensor>\n%s</scene>";
    int size = int_or(view->size, 16);
    size_t bytes = strlen(frame) + strlen(content) + 512;
    char *text = malloc(bytes);
    struct brdfcl_scene *scene = NULL;
    struct brdf_error error = {BRDF_OK, ""};
    assert_non_null(text);
    snprintf(text, bytes, frame, int_or(view->depth, 5), int_or(view->rr_depth, 1000),
             view->fov > 0.0 ? view->fov : 45.0, text_or(view->from, "0, 1, 4"),
             text_or(view->to, "0, 0.5, 0"), text_or(view->sampler, "independent"),
             int_or(view->spp, 4), size, size, text_or(view->filter, "box"), content);
    brdf_status status = scene_text_load(text, NULL, 0, &scene, &error);
    free(text);
    if (status) {
        fail_msg("%s", error.message);
    }
    return scene;
}

struct brdfcl_render_result render_by(const struct renderer *who, const struct brdfcl_scene *scene)
{
    struct brdfcl_render_options options = {0};
    struct brdfcl_render_result result;
    struct brdf_error error = {BRDF_OK, ""};
    brdf_status status = BRDF_OK;
    options.threads = who->threads;
    options.pool = who->pool;
    if (who->lanes) {
        status = brdfcl_device_open("", who->lanes, 0, &options.device, &error);
    }
    if (!status) {
        status = brdfcl_render(scene, &options, &result, &error);
    }
    brdfcl_device_close(options.device);
    if (status) {
        fail_msg("%d lanes: %s", who->lanes, error.message);
    }
    assert_int_equal(result.invalid, 0);
    assert_int_equal(result.stopped, 0);
    assert_int_equal(result.spp, brdfcl_scene_get_info(scene).spp);
    return result;
}

unsigned long long render_hash(const struct renderer *who, const struct brdfcl_scene *scene)
{
    struct brdfcl_render_result result = render_by(who, scene);
    unsigned long long hash = brdfcl_image_hash(&result.image);
    brdfcl_image_destroy(&result.image);
    return hash;
}

struct estimate render_estimate(const struct view *view, const char *content)
{
    const struct renderer in_c = {0, 0, 0};
    struct brdfcl_scene *scene = render_scene_load(view, content);
    struct brdfcl_render_result result = render_by(&in_c, scene);
    size_t pixels = (size_t)result.image.width * (size_t)result.image.height;
    struct estimate e = {0.0, 0.0, HUGE_VAL, -HUGE_VAL};
    for (size_t i = 0; i < pixels; ++i) {
        double value = (double)result.image.rgb[3 * i];
        e.mean += value / (double)pixels;
        e.least = fmin(e.least, value);
        e.most = fmax(e.most, value);
    }
    double squares = 0.0;
    for (size_t i = 0; i < pixels; ++i) {
        double off = (double)result.image.rgb[3 * i] - e.mean;
        squares += off * off;
    }
    e.error = sqrt(squares / ((double)pixels * (double)(pixels - 1)));
    brdfcl_image_destroy(&result.image);
    brdfcl_scene_destroy(scene);
    return e;
}

void assert_estimate(const char *name, struct estimate estimate, double expected, double slack,
                     double noise)
{
    double off = fabs(estimate.mean - expected);
    if (!(off <= 4.5 * estimate.error + slack * expected)) {
        fail_msg("%s: %.6f +- %.6f, expected %.6f", name, estimate.mean, estimate.error, expected);
    }
    if (!(estimate.error <= noise * expected)) {
        fail_msg("%s: %.6f +- %.6f is too noisy to say anything about %.6f", name, estimate.mean,
                 estimate.error, expected);
    }
}

const char *text_of(double number)
{
    static char texts[16][32];
    static int next;
    next = (next + 1) % 16;
    snprintf(texts[next], sizeof texts[next], "%.9g", number);
    return texts[next];
}
