/* draw.c - see draw.h. */
#include "draw.h"
#include "angle.h"

#include <brdf/warp.h>

struct lab_draw lab_draw_make(const struct brdf_bsdf *bsdf, brdf_vec3 wo, size_t i, brdf_vec3 u)
{
    struct lab_draw draw = {brdf_warp_cosine(u.x, u.y), 0.0};
    if (i % 2 == 1) {
        struct brdf_sample sample = brdf_sample(bsdf, wo, u);
        if (sample.pdf <= 0.0f || sample.delta) {
            return draw;
        }
        draw.wi = sample.wi;
    }
    if (draw.wi.z > 0.0f) {
        double cosine = (double)draw.wi.z;
        draw.weight = cosine / (0.5 * cosine / pi + 0.5 * (double)brdf_pdf(bsdf, wo, draw.wi));
    }
    return draw;
}
