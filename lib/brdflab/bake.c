/* bake.c - materials into tables, and what keeps one from being tabulated. */
#include "bake.h"

#include <math.h>

#include <brdf/info.h>
#include <brdf/model.h>
#include <brdf/warp.h>

#include "angle.h"
#include "lattice.h"

enum { PROBES = 512 };

/* Relative differences below this are rounding, or interpolation in a table of the azimuth. */
static const double same = 0.02;

/* A pair of directions that the material reflects along: wi is drawn from it. */
struct probe {
    brdf_vec3 wo;
    struct brdf_sample sample;
};

static struct probe probe_make(const struct brdf_bsdf *bsdf, const struct lab_lattice *lattice,
                               size_t i)
{
    struct probe probe;
    probe.wo = brdf_warp_cosine(lab_lattice_at(lattice, i, 0), lab_lattice_at(lattice, i, 1));
    brdf_vec3 u = brdf_vec3_make(lab_lattice_at(lattice, i, 2), lab_lattice_at(lattice, i, 3),
                                 lab_lattice_at(lattice, i, 4));
    probe.sample = brdf_sample(bsdf, probe.wo, u);
    return probe;
}

static brdf_vec3 turn(brdf_vec3 w, double angle)
{
    float c = (float)cos(angle), s = (float)sin(angle);
    return brdf_vec3_make(c * w.x - s * w.y, s * w.x + c * w.y, w.z);
}

int lab_has_delta(const struct brdf_bsdf *bsdf)
{
    struct lab_lattice lattice = lab_lattice_make(5, 1);
    for (size_t i = 0; i < PROBES; ++i) {
        struct probe probe = probe_make(bsdf, &lattice, i);
        if (probe.sample.pdf > 0.0f && probe.sample.delta) {
            return 1;
        }
    }
    return 0;
}

/* The largest difference of f to itself where the pair of directions is changed in some way. */
static double difference_under(const struct brdf_bsdf *bsdf,
                               brdf_vec3 (*change)(brdf_vec3 w, double angle))
{
    struct lab_lattice lattice = lab_lattice_make(5, 2);
    double worst = 0.0;
    for (size_t i = 0; i < PROBES; ++i) {
        struct probe probe = probe_make(bsdf, &lattice, i);
        if (probe.sample.pdf <= 0.0f) {
            continue;
        }
        double angle = pi * (0.2 + 0.8 * (double)i / PROBES); /* half a turn need not show it */
        double f = (double)brdf_eval(bsdf, probe.wo, probe.sample.wi).g;
        double g =
            (double)brdf_eval(bsdf, change(probe.wo, angle), change(probe.sample.wi, angle)).g;
        double larger = fmax(f, g);
        worst = larger > 0.0 ? fmax(worst, fabs(f - g) / larger) : worst;
    }
    return worst;
}

static brdf_vec3 half_turn(brdf_vec3 w, double angle)
{
    (void)angle;
    return brdf_vec3_make(-w.x, -w.y, w.z);
}

static brdf_vec3 mirror(brdf_vec3 w, double angle)
{
    (void)angle;
    return brdf_vec3_make(-w.x, w.y, w.z);
}

double lab_anisotropy(const struct brdf_bsdf *bsdf)
{
    return difference_under(bsdf, turn);
}

int lab_symmetry(const struct brdf_bsdf *bsdf)
{
    if (difference_under(bsdf, half_turn) > same) {
        return 1;
    }
    return difference_under(bsdf, mirror) > same ? 2 : 4;
}

static brdf_status refuse_what_no_table_holds(const struct brdf_bsdf *bsdf,
                                              struct brdf_error *error)
{
    const struct brdf_material *material = brdf_bsdf_material(bsdf);
    const char *name = brdf_model_info((int)material->model)->name;
    if (material->flags & BRDF_TRANSMISSION) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "%s lets light through, and a measured file holds reflection only", name);
    }
    if (material->flags & BRDF_DELTA || lab_has_delta(bsdf)) {
        return brdf_fail(
            error, BRDF_UNSUPPORTED,
            "%s reflects into a mirror direction, which no table can hold; use a rough "
            "model of small alpha",
            name);
    }
    return BRDF_OK;
}

static void value_at(const double wo[3], const double wi[3], double rgb[3], void *data)
{
    const struct brdf_bsdf *bsdf = *(const struct brdf_bsdf *const *)data;
    brdf_vec3 o = brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]);
    brdf_vec3 i = brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]);
    brdf_rgb there = brdf_eval(bsdf, o, i);
    brdf_rgb back = brdf_eval(bsdf, i, o);
    rgb[0] = fmax(0.0, 0.5 * ((double)there.r + (double)back.r));
    rgb[1] = fmax(0.0, 0.5 * ((double)there.g + (double)back.g));
    rgb[2] = fmax(0.0, 0.5 * ((double)there.b + (double)back.b));
}

brdf_status lab_bake_merl(const struct brdf_bsdf *bsdf, struct brdf_merl_file *file,
                          struct brdf_error *error)
{
    brdf_status status = refuse_what_no_table_holds(bsdf, error);
    if (status) {
        return status;
    }
    if (brdf_bsdf_material(bsdf)->flags & BRDF_ANISOTROPIC && lab_anisotropy(bsdf) > same) {
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "the material looks different when turned about its normal, and MERL's "
                         "layout holds isotropic ones only; convert it to .bsdf");
    }
    return brdf_merl_make(value_at, &bsdf, file, error);
}

static void channels_at(const double wo[3], const double wi[3], int channels,
                        const float *wavelengths, double *values, void *data)
{
    const struct brdf_bsdf *bsdf = *(const struct brdf_bsdf *const *)data;
    (void)channels;
    (void)wavelengths;
    brdf_rgb f = brdf_eval(bsdf, brdf_vec3_make((float)wo[0], (float)wo[1], (float)wo[2]),
                           brdf_vec3_make((float)wi[0], (float)wi[1], (float)wi[2]));
    values[0] = fmax(0.0, (double)f.r);
    values[1] = fmax(0.0, (double)f.g);
    values[2] = fmax(0.0, (double)f.b);
}

brdf_status lab_bake_rgl(const struct brdf_bsdf *bsdf, const struct brdf_rgl_grid *grid,
                         struct brdf_rgl_file *file, struct brdf_error *error)
{
    struct brdf_rgl_grid fine = *grid;
    brdf_status status = refuse_what_no_table_holds(bsdf, error);
    if (status) {
        return status;
    }
    if (fine.phis == 0 && brdf_bsdf_material(bsdf)->flags & BRDF_ANISOTROPIC &&
        lab_anisotropy(bsdf) > same) {
        fine.symmetry = fine.symmetry ? fine.symmetry : lab_symmetry(bsdf);
        fine.phis = 32 / fine.symmetry + 1;
    }
    fine.thetas = fine.thetas ? fine.thetas : 25;
    fine.size = fine.size ? fine.size : fine.phis > 1 ? 64 : 128;
    return brdf_rgl_make(channels_at, &bsdf, &fine, file, error);
}
