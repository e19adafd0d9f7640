/*
 * survey.h - what can be said of a measured material before it is trusted.
 */
#ifndef BRDFLAB_SURVEY_H
#define BRDFLAB_SURVEY_H

#include <stddef.h>

#include <brdf/material.h>
#include <brdf/merl.h>
#include <brdf/rgl.h>

enum { LAB_SURVEY_ANGLES = 9 };

/* The angles of the albedos [degrees]. */
extern const double lab_survey_angles[LAB_SURVEY_ANGLES];

/* What any material can be asked, by evaluating it. */
struct lab_survey {
    double albedo[LAB_SURVEY_ANGLES][3];
    double albedo_diffuse[3]; /* under light from everywhere: the average over the cosine */
    double reciprocity;       /* lab_reciprocity */
    double energy;            /* the largest albedo found */
    double energy_angle;      /* ... and at which angle [degrees] */
    double energy_from;       /* the least angle found with an albedo above 1; 90: none */
};

void lab_survey_make(const struct brdf_bsdf *bsdf, struct lab_survey *survey);

/* How far from reciprocal: the integral of |f(wo, wi) - f(wi, wo)| over that of f, all pairs of
   directions above the surface with both cosines as weights. */
double lab_reciprocity(const struct brdf_bsdf *bsdf);

/* The place of a bin: angles of its centre [degrees]. */
struct lab_place {
    double theta_h, theta_d, phi_d;
};

/* What a MERL table says of itself, read with BRDF_MERL_INVALID_KEEP. */
struct lab_merl_survey {
    size_t bins, valid;
    size_t above;         /* bins whose centre has both directions above the surface */
    size_t above_invalid; /* of these, not measured ... */
    double invalid_from;  /* ... all of them with a direction this far from the normal [degrees] */
    size_t zero;          /* valid bins with a channel that is exactly 0 */
    double least, most;   /* of valid bins and channels [1/sr] */
    struct lab_place least_at, most_at;
    double noise;         /* from bin to bin: see survey_merl.c; relative, up to 60 degrees */
    double noise_grazing; /* the same beyond 60 degrees */
    int folded;           /* the file had 360 bins of phi_d; read as struct brdf_merl_file says */
    double folding;       /* ... and so far apart were those that reciprocity makes equal */
};

void lab_survey_merl(const struct brdf_merl_file *file, struct lab_merl_survey *survey);

/* A pair of directions as degrees from the normal, and the azimuth between them [degrees]. */
struct lab_pair {
    double theta_o, theta_i, phi;
};

/* What an RGL file says of itself. */
struct lab_rgl_survey {
    int phis, thetas, size; /* azimuths and polar angles of wo; nodes along a view's square */
    int channels, spectral; /* 3, or how many wavelengths; whether they are wavelengths */
    double theta_most;      /* the last polar angle [degrees] */
    double negative;        /* the share of values below 0 */
    double least, most;     /* of f, RGB [1/sr], at directions drawn from each view ... */
    struct lab_pair least_at, most_at; /* ... and where that is */
};

/* `bsdf` is the model measured, of the same file. */
void lab_survey_rgl(const struct brdf_rgl_file *file, const struct brdf_bsdf *bsdf,
                    struct lab_rgl_survey *survey);

/* What is known of a material; `merl` and `rgl` are NULL if it is not of that format. */
struct lab_findings {
    const struct lab_survey *all;
    const struct lab_merl_survey *merl;
    const struct lab_rgl_survey *rgl;
    int fill; /* bins of a MERL file that were not measured are filled, and not 0 */
};

/*
 * A doubt in a sentence, number 0, 1, ... of those there are; NULL after the last.
 * The text is in `text` of `size` bytes.
 */
const char *lab_survey_doubt(const struct lab_findings *findings, int number, char *text,
                             size_t size);

#endif
