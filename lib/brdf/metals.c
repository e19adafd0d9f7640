/*
 * metals.c - complex refractive indices of metals, three numbers a metal out of a measured
 * spectrum.
 *
 * Data: refractiveindex.info database (CC0), the authors named in each row. Method, in full in
 * docs/metals.md: the spectra of eta and k are averaged with the CIE 1931 2-degree colour matching
 * functions turned to linear Rec. 709 and normalised so that a constant spectrum gives itself. From
 * there eta and k of each channel are moved, as little as it takes, until the Fresnel reflectance
 * at eleven angles fits the one computed wavelength by wavelength and averaged the same way.
 * Averages alone are wrong by up to 0.038 (gold), the fit by up to 0.019 (gold red, which is
 * outside of Rec. 709: 1.007 at normal incidence) and 0.002 for all others.
 */
#include "brdf/substance.h"

#include "brdf/info.h"

#include <string.h>

static const struct brdf_metal metals[] = {
    {"Ag", {0.0551f, 0.0547f, 0.0427f}, {4.3366f, 3.5479f, 2.5487f}, "Johnson and Christy 1972"},
    {"Al", {1.4556f, 0.9867f, 0.5924f}, {7.5606f, 6.5534f, 5.2968f}, "Rakic 1995"},
    {"Au", {0.0675f, 0.4912f, 1.4889f}, {10.0244f, 2.2667f, 1.7602f}, "Johnson and Christy 1972"},
    {"Be", {3.4442f, 3.3415f, 3.0466f}, {3.1766f, 3.1505f, 3.1395f}, "Rakic et al. 1998"},
    {"Bi", {2.2916f, 2.0170f, 1.6577f}, {3.1540f, 2.8441f, 2.4016f}, "Hagemann et al. 1975"},
    {"Co", {2.2347f, 2.0380f, 1.7028f}, {4.1894f, 3.7990f, 3.2198f}, "Johnson and Christy 1974"},
    {"Cr", {3.2205f, 3.1227f, 2.2634f}, {3.2919f, 3.3365f, 3.1040f}, "Johnson and Christy 1974"},
    {"Cu", {0.2586f, 1.0428f, 1.3037f}, {3.1989f, 2.6243f, 2.3474f}, "Johnson and Christy 1972"},
    {"Fe", {2.9156f, 2.9231f, 2.5325f}, {3.0674f, 2.9383f, 2.7420f}, "Johnson and Christy 1974"},
    {"Hg", {2.0006f, 1.5229f, 1.0095f}, {5.2524f, 4.6109f, 3.7656f}, "Inagaki et al. 1981"},
    {"Ir", {3.0355f, 2.6004f, 2.1339f}, {5.5787f, 5.0843f, 4.3099f}, "Schmitt et al. 2022"},
    {"Mg", {0.4070f, 0.3086f, 0.2086f}, {5.9153f, 4.9724f, 3.9106f}, "Hagemann et al. 1975"},
    {"Mo", {3.4526f, 3.3643f, 2.7841f}, {3.5421f, 3.6515f, 3.5143f}, "Kirillova et al. 1971"},
    {"Nb", {2.9036f, 2.9139f, 2.6124f}, {2.8349f, 2.8867f, 2.8038f}, "Weaver et al. 1973"},
    {"Ni", {2.0159f, 1.9051f, 1.7240f}, {4.1412f, 3.5762f, 2.8753f}, "Johnson and Christy 1974"},
    {"Pb", {2.6019f, 2.5593f, 2.0372f}, {4.1726f, 4.1821f, 4.1750f}, "Mathewson and Myers 1971"},
    {"Pd", {1.7780f, 1.6235f, 1.3888f}, {4.3147f, 3.8168f, 3.1936f}, "Johnson and Christy 1974"},
    {"Pt", {2.3260f, 2.0769f, 1.8242f}, {4.1879f, 3.6728f, 3.0775f}, "Rakic et al. 1998"},
    {"Rh", {2.1519f, 1.9632f, 1.7123f}, {5.6531f, 4.9597f, 4.3852f}, "Weaver et al. 1977"},
    {"Ti", {2.7237f, 2.5104f, 2.2305f}, {3.8041f, 3.4010f, 3.0055f}, "Johnson and Christy 1974"},
    {"V", {3.4969f, 3.9674f, 3.5998f}, {2.9994f, 3.0702f, 3.4834f}, "Johnson and Christy 1974"},
    {"W", {3.6252f, 3.4946f, 3.3122f}, {2.9108f, 2.7492f, 2.4971f}, "Weaver et al. 1975"},
    {"Zn", {1.1879f, 0.9141f, 0.6528f}, {5.7542f, 4.9243f, 3.9004f}, "Werner et al. 2009"},
    {"Zr", {3.0746f, 2.4998f, 1.9242f}, {3.5842f, 3.3415f, 2.8162f}, "Querry 1987"},
    {"none", {0.0f, 0.0f, 0.0f}, {1.0f, 1.0f, 1.0f}, "reflects everything"},
};

enum { METALS = sizeof metals / sizeof metals[0] };

const struct brdf_metal *brdf_metal_at(int i)
{
    return i >= 0 && i < METALS ? &metals[i] : NULL;
}

const struct brdf_metal *brdf_metal_find(const char *name)
{
    for (int i = 0; i < METALS; ++i) {
        if (strcmp(metals[i].name, name) == 0) {
            return &metals[i];
        }
    }
    return NULL;
}

const char *brdf_metal_nearest(const char *name)
{
    const char *names[METALS];
    for (int i = 0; i < METALS; ++i) {
        names[i] = metals[i].name;
    }
    return brdf_name_nearest(name, names, METALS);
}
