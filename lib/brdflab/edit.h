/*
 * edit.h - a measured material changed: its highlight, its diffuse part, its colour.
 */
#ifndef BRDFLAB_EDIT_H
#define BRDFLAB_EDIT_H

#include <brdf/merl.h>

/* What hue and saturation are changed of. */
enum lab_edit_part { LAB_EDIT_ALL, LAB_EDIT_DIFFUSE, LAB_EDIT_SPECULAR };

struct lab_edit {
    double gloss;      /* > 0; the highlight becomes so many times narrower */
    double specular;   /* >= 0; factor on the highlight */
    double diffuse;    /* >= 0; factor on the diffuse part */
    double hue;        /* rad; turned by so much, oklab.h */
    double saturation; /* >= 0; factor on the chroma */
    enum lab_edit_part part;
    int metal; /* 1: there is no diffuse part, all of f is the highlight; 0: separate.h finds it */
};

/* All factors 1, nothing turned: a change of nothing. */
struct lab_edit lab_edit_nothing(void);

/* Does the edit change nothing? */
int lab_edit_is_nothing(const struct lab_edit *edit);

/*
 * Edit a table. The highlight is made narrower or wider in the slopes of the half vectors,
 * tan(theta_h): a distribution of slopes that is stretched by 1 / gloss and divided by its square
 * keeps its integral, so the highlight keeps its energy, but for what then leaves below the
 * surface. What is moved is the distribution of normals: f without masking over the cosines, for
 * which V-shaped grooves stand in [Torrance and Sparrow 1967], since their masking does not depend
 * on the roughness. For a lobe of such grooves whose shape does not depend on its width (GGX,
 * Beckmann [Heitz 2014, section 5.3]) the result is that of alpha / gloss; for one with Smith's
 * masking it comes near. Invalid bins stay invalid; an edit of nothing keeps every bit. `edited` is
 * the caller's, for brdf_merl_free. Errors: BRDF_BAD_ARGUMENT (a factor out of range, a table
 * without a valid bin), BRDF_OUT_OF_MEMORY.
 */
brdf_status lab_edit_merl(const struct brdf_merl_file *file, const struct lab_edit *edit,
                          struct brdf_merl_file *edited, struct brdf_error *error);

#endif
