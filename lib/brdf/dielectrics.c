/*
 * dielectrics.c - refractive indices of dielectrics by name.
 *
 * Names and values are those that Mitsuba's plugins accept (the table of names in the documentation
 * of its `dielectric` plugin), so that its scenes mean the same here: gases at 0 C and 1 atm,
 * liquids at 20 C, solids at room temperature, all near 589 nm. `bk7` is the value that renderers
 * use; Schott's N-BK7 has 1.5168 at 587.6 nm. `glass` is ours: crown glass, rounded.
 */
#include "brdf/substance.h"

#include "brdf/info.h"

#include <string.h>

static const struct brdf_dielectric_substance dielectrics[] = {
    {"acetone", 1.36f},
    {"acrylic glass", 1.49f},
    {"air", 1.000277f},
    {"amber", 1.55f},
    {"benzene", 1.501f},
    {"bk7", 1.5046f},
    {"bromine", 1.661f},
    {"carbon dioxide", 1.00045f},
    {"carbon tetrachloride", 1.461f},
    {"diamond", 2.419f},
    {"ethanol", 1.361f},
    {"fused quartz", 1.458f},
    {"glass", 1.5f},
    {"glycerol", 1.4729f},
    {"helium", 1.000036f},
    {"hydrogen", 1.000132f},
    {"pet", 1.5750f},
    {"polypropylene", 1.49f},
    {"pyrex", 1.470f},
    {"silicone oil", 1.52045f},
    {"sodium chloride", 1.544f},
    {"vacuum", 1.0f},
    {"water", 1.3330f},
    {"water ice", 1.31f},
};

enum { DIELECTRICS = sizeof dielectrics / sizeof dielectrics[0] };

const struct brdf_dielectric_substance *brdf_dielectric_at(int i)
{
    return i >= 0 && i < DIELECTRICS ? &dielectrics[i] : NULL;
}

const struct brdf_dielectric_substance *brdf_dielectric_find(const char *name)
{
    for (int i = 0; i < DIELECTRICS; ++i) {
        if (strcmp(dielectrics[i].name, name) == 0) {
            return &dielectrics[i];
        }
    }
    return NULL;
}

const char *brdf_dielectric_nearest(const char *name)
{
    const char *names[DIELECTRICS];
    for (int i = 0; i < DIELECTRICS; ++i) {
        names[i] = dielectrics[i].name;
    }
    return brdf_name_nearest(name, names, DIELECTRICS);
}
