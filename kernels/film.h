/*
 * film.h - stage 6: the samples of each pixel are added, in the order of their numbers.
 *
 * reads: the radiance of finished paths; writes: sums. The order is fixed and each addition is
 * compensated [Kahan 1965; Neumaier's order is not needed, as radiance is not negative], so that
 * neither the pool nor the number of passes changes a bit, and thousands of samples lose nothing.
 */
#ifndef PT_FILM_H
#define PT_FILM_H

#include "lanes.h"
#include "path.h"

/* A pixel's sums: r, g, b, unused, and the compensation of each. */
#define PT_FILM_WORDS 8

/* Not infinite and not a NaN: its exponent is not all ones. */
static inline int pt_is_finite(float x)
{
    return (pt_int_bits(x) & 0x7f800000) != 0x7f800000;
}

/* Pixel `number` of the pass: a plain loop over its samples, one pixel a work-item. */
static inline void pt_film(struct pt_world w, struct pt_pass pass, BRDF_GLOBAL float *film,
                           int number)
{
    BRDF_GLOBAL float *pixel = film + (pass.first_pixel + number) * PT_FILM_WORDS;
    BRDF_GLOBAL const float *radiance = w.radiance + (number << pass.sample_bits) * 4;
    int samples = 1 << pass.sample_bits;
    int invalid = 0;
    for (int s = 0; s < samples; ++s) {
        int finite = pt_is_finite(radiance[0] + radiance[1] + radiance[2]);
        invalid += !finite;
        for (int c = 0; c < 3; ++c) {
            float term = (finite ? radiance[c] : 0.0f) - pixel[4 + c];
            float sum = pixel[c] + term;
            pixel[4 + c] = (sum - pixel[c]) - term;
            pixel[c] = sum;
        }
        radiance += 4;
    }
    if (invalid) {
        pt_claim(w.queues + PT_INVALID, invalid);
    }
}

#endif
