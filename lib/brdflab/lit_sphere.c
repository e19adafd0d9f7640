/* lit_sphere.c - samples of the material, and samples of the lamps. */
#include "lit_sphere.h"

#include <math.h>
#include <stdlib.h>

#include "lattice.h"
#include "studio.h"

/*
 * Neighbouring pixels take different parts of one lattice, so that each square of 4 x 4 pixels has
 * all of it: the mean over such squares is as smooth as if each pixel had all samples.
 */
enum {
    TILE = 4,
    PARTS = TILE * TILE,
    SAMPLES = 8,      /* of the material, for each pixel */
    LAMP_SAMPLES = 3, /* of each lamp */
    DIMENSIONS = 8,
    BOUNCES = 6 /* within the sphere */
};

static const float indirect_most = 2.0f;

struct pattern {
    float u[DIMENSIONS][SAMPLES]; /* 3 to enter or reflect, 3 to leave, 2 for a lamp then */
    brdf_vec3 lamp[STUDIO_LAMPS][LAMP_SAMPLES]; /* directions, in the world */
};

struct sphere {
    const struct brdf_bsdf *bsdf;
    struct studio studio;
    struct pattern pattern[PARTS];
};

/* A place on the sphere. */
struct spot {
    brdf_vec3 normal;
    brdf_frame frame;
    brdf_vec3 wo;    /* local */
    unsigned random; /* state of next_random */
};

static void sphere_init(struct sphere *sphere, const struct brdf_bsdf *bsdf)
{
    sphere->bsdf = bsdf;
    sphere->studio = studio_make();
    struct lab_lattice material = lab_lattice_make(DIMENSIONS, 1);
    struct lab_lattice lamp = lab_lattice_make(2, 2);
    for (size_t part = 0; part < PARTS; ++part) {
        struct pattern *pattern = &sphere->pattern[part];
        for (size_t i = 0; i < SAMPLES; ++i) {
            for (int d = 0; d < DIMENSIONS; ++d) {
                pattern->u[d][i] = lab_lattice_at(&material, i * PARTS + part, d);
            }
        }
        for (size_t i = 0; i < LAMP_SAMPLES; ++i) {
            double u = (double)lab_lattice_at(&lamp, i * PARTS + part, 0);
            double v = (double)lab_lattice_at(&lamp, i * PARTS + part, 1);
            for (int k = 0; k < STUDIO_LAMPS; ++k) {
                pattern->lamp[k][i] = studio_lamp_sample(&sphere->studio.lamp[k], u, v);
            }
        }
    }
}

static brdf_frame frame_at(brdf_vec3 normal)
{
    return brdf_frame_from_tangent(normal, brdf_cross(brdf_vec3_make(0.0f, 1.0f, 0.0f), normal));
}

/* Uniform in [0, 1): xorshift [Marsaglia 2003]. */
static float next_random(unsigned *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 17;
    *state ^= *state << 5;
    return (float)(*state >> 8) * (1.0f / 16777216.0f);
}

/*
 * The light that a sample of the material brings from outside: all of the sky, and of a lamp what
 * samples of the lamp leave to it, where `lamp_samples` of them are taken for each `samples` of the
 * material.
 */
static float light_of_sample(const struct sphere *sphere, brdf_vec3 w, float pdf, int delta,
                             int samples, int lamp_samples)
{
    double light = studio_sky_light(w);
    for (int k = 0; k < STUDIO_LAMPS; ++k) {
        const struct studio_lamp *lamp = &sphere->studio.lamp[k];
        if (studio_lamp_holds(lamp, w)) {
            double ours = samples * (double)pdf;
            double theirs = delta ? 0.0 : lamp_samples * lamp->density;
            light += studio_lamp_light(lamp, w) * (delta ? 1.0 : ours / (ours + theirs));
        }
    }
    return (float)light;
}

/* f cos / density of a sample of a lamp, lessened by what samples of the material bring. */
static brdf_rgb light_of_lamp(const struct sphere *sphere, const struct studio_lamp *lamp,
                              const brdf_frame *frame, brdf_vec3 wo, brdf_vec3 w, int samples,
                              int lamp_samples)
{
    brdf_vec3 wi = brdf_to_local(*frame, w);
    if (wi.z <= 0.0f) {
        return brdf_gray(0.0f);
    }
    double both = lamp_samples * lamp->density + samples * (double)brdf_pdf(sphere->bsdf, wo, wi);
    double factor = studio_lamp_light(lamp, w) * (double)wi.z / both;
    return brdf_rgb_scale(brdf_eval(sphere->bsdf, wo, wi), (float)factor);
}

/* The numbers of a place within the sphere: of the pattern where a path first gets to the other
   side, as most that leave do so there; random from then on. */
struct numbers {
    brdf_vec3 u;
    double lamp[2];
};

static struct numbers next_numbers(const struct pattern *pattern, int i, int bounce,
                                   unsigned *random)
{
    float x[DIMENSIONS - 3];
    for (int d = 0; d < DIMENSIONS - 3; ++d) {
        x[d] = bounce == 0 ? pattern->u[3 + d][i] : next_random(random);
    }
    struct numbers numbers = {{x[0], x[1], x[2]}, {(double)x[3], (double)x[4]}};
    return numbers;
}

/*
 * What comes back along a ray that has entered at `point` and goes on along w, as sample i. Light
 * that was reflected within is looked for by the material alone, and a lamp that is found so shines
 * no brighter than indirect_most: a few specks less, for a little light.
 */
static brdf_rgb light_through(const struct sphere *sphere, const struct pattern *pattern, int i,
                              brdf_vec3 point, brdf_vec3 w, unsigned *random)
{
    brdf_rgb sum = brdf_gray(0.0f);
    brdf_rgb weight = brdf_gray(1.0f);
    for (int bounce = 0; bounce < BOUNCES; ++bounce) {
        point = brdf_normalize(brdf_sub(point, brdf_scale(w, 2.0f * brdf_dot(point, w))));
        brdf_frame frame = frame_at(point);
        brdf_vec3 wo = brdf_to_local(frame, brdf_negate(w));
        struct numbers numbers = next_numbers(pattern, i, bounce, random);
        for (int k = 0; k < STUDIO_LAMPS && bounce == 0; ++k) {
            const struct studio_lamp *lamp = &sphere->studio.lamp[k];
            brdf_vec3 to_lamp = studio_lamp_sample(lamp, numbers.lamp[0], numbers.lamp[1]);
            brdf_rgb light = light_of_lamp(sphere, lamp, &frame, wo, to_lamp, 1, 1);
            sum = brdf_rgb_add(sum, brdf_rgb_mul(weight, light));
        }
        struct brdf_sample s = brdf_sample(sphere->bsdf, wo, numbers.u);
        if (!(s.pdf > 0.0f)) {
            break;
        }
        weight = brdf_rgb_mul(weight, s.weight);
        w = brdf_to_world(frame, s.wi);
        if (s.wi.z > 0.0f) {
            float light = light_of_sample(sphere, w, s.pdf, s.delta != 0, 1, bounce == 0);
            light = bounce == 0 ? light : brdf_min(light, indirect_most);
            return brdf_rgb_add(sum, brdf_rgb_scale(weight, light));
        }
    }
    return sum;
}

static brdf_rgb light_by_material(const struct sphere *sphere, const struct pattern *pattern,
                                  struct spot *spot)
{
    float wo[3][SAMPLES], wi[3][SAMPLES], weight[3][SAMPLES], pdf[SAMPLES];
    int delta[SAMPLES];
    for (int i = 0; i < SAMPLES; ++i) {
        wo[0][i] = spot->wo.x;
        wo[1][i] = spot->wo.y;
        wo[2][i] = spot->wo.z;
    }
    struct brdf_vectors from = {wo[0], wo[1], wo[2]};
    struct brdf_vectors u = {pattern->u[0], pattern->u[1], pattern->u[2]};
    struct brdf_samples samples = {wi[0], wi[1], wi[2], {weight[0], weight[1], weight[2]},
                                   pdf,   NULL,  delta};
    brdf_sample_many(sphere->bsdf, SAMPLES, from, u, samples);
    brdf_rgb sum = brdf_gray(0.0f);
    for (int i = 0; i < SAMPLES; ++i) {
        if (!(pdf[i] > 0.0f)) {
            continue;
        }
        brdf_vec3 w = brdf_to_world(spot->frame, brdf_vec3_make(wi[0][i], wi[1][i], wi[2][i]));
        brdf_rgb light =
            wi[2][i] < 0.0f
                ? light_through(sphere, pattern, i, spot->normal, w, &spot->random)
                : brdf_gray(light_of_sample(sphere, w, pdf[i], delta[i], SAMPLES, LAMP_SAMPLES));
        brdf_rgb share = brdf_rgb_make(weight[0][i], weight[1][i], weight[2][i]);
        sum = brdf_rgb_add(sum, brdf_rgb_mul(share, light));
    }
    return brdf_rgb_scale(sum, 1.0f / SAMPLES);
}

static brdf_rgb light_at(const struct sphere *sphere, const struct pattern *pattern,
                         struct spot *spot)
{
    brdf_rgb sum = light_by_material(sphere, pattern, spot);
    for (int k = 0; k < STUDIO_LAMPS; ++k) {
        for (int i = 0; i < LAMP_SAMPLES; ++i) {
            sum = brdf_rgb_add(sum,
                               light_of_lamp(sphere, &sphere->studio.lamp[k], &spot->frame,
                                             spot->wo, pattern->lamp[k][i], SAMPLES, LAMP_SAMPLES));
        }
    }
    return sum;
}

/* The place that is seen at (x, y), -1 to 1; beyond the edge, the edge. */
static struct spot spot_at(double x, double y, unsigned number)
{
    struct spot spot;
    double r = hypot(x, y);
    double inward = fmin(1.0, 0.9999 / fmax(r, 1e-9));
    double z = sqrt(fmax(0.0, 1.0 - r * r * inward * inward));
    spot.normal =
        brdf_normalize(brdf_vec3_make((float)(x * inward), (float)(y * inward), (float)z));
    spot.frame = frame_at(spot.normal);
    spot.wo = brdf_to_local(spot.frame, brdf_vec3_make(0.0f, 0.0f, 1.0f));
    spot.random = 2654435761u * (number + 1u);
    spot.random += spot.random == 0u; /* the one state that xorshift does not leave */
    return spot;
}

/* Linear up to 0.6, and from there towards 1 without reaching it. */
static float rolled_off(float x)
{
    const double knee = 0.6;
    double beyond = ((double)x - knee) / (1.0 - knee);
    return beyond <= 0.0 ? x : (float)(1.0 - (1.0 - knee) * exp(-beyond));
}

/* The light at a pixel of a picture that is TILE - 1 pixels wider and higher, to be averaged. */
static brdf_rgb light_at_pixel(const struct sphere *sphere, int size, int column, int row)
{
    double x = (2.0 * column + 2.0 - TILE) / size - 1.0;
    double y = 1.0 - (2.0 * row + 2.0 - TILE) / size;
    if (hypot(x, y) > 1.0 + 8.0 / size) {
        return brdf_gray(0.0f);
    }
    struct spot spot = spot_at(x, y, (unsigned)row * 65537u + (unsigned)column);
    return light_at(sphere, &sphere->pattern[row % TILE * TILE + column % TILE], &spot);
}

/* Means over squares, of rows that hold what begins at this row. */
static void write_row(float *const row[TILE], int size, float *rgb)
{
    for (int x = 0; x < 3 * size; ++x) {
        float sum = 0.0f;
        for (int j = 0; j < TILE; ++j) {
            for (int i = 0; i < TILE; ++i) {
                sum += row[j][x + 3 * i];
            }
        }
        rgb[x] = rolled_off(sum / PARTS);
    }
}

brdf_status lab_lit_sphere(const struct brdf_bsdf *bsdf, int size, float *rgb,
                           struct brdf_error *error)
{
    struct sphere sphere;
    int wide = size + TILE - 1;
    float *light = malloc((size_t)TILE * 3 * (size_t)wide * sizeof *light);
    if (!light) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory for rows of %d pixels", wide);
    }
    sphere_init(&sphere, bsdf);
    for (int y = 0; y < wide; ++y) {
        float *row[TILE];
        for (int i = 0; i < TILE; ++i) {
            row[i] = light + (size_t)((y + 1 + i) % TILE) * 3 * (size_t)wide;
        }
        for (int x = 0; x < wide; ++x) {
            brdf_rgb sum = light_at_pixel(&sphere, size, x, y);
            row[TILE - 1][3 * x] = sum.r;
            row[TILE - 1][3 * x + 1] = sum.g;
            row[TILE - 1][3 * x + 2] = sum.b;
        }
        if (y >= TILE - 1) {
            write_row(row, size, rgb + (size_t)(y - TILE + 1) * 3 * (size_t)size);
        }
    }
    free(light);
    return BRDF_OK;
}
