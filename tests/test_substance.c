/* test_substance.c - metals and dielectrics against numbers that were computed elsewhere. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <string.h>

#include <brdf/substance.h>

/*
 * Reflectance at normal incidence, computed wavelength by wavelength from the measured spectra and
 * averaged to linear Rec. 709 (docs/metals.md): what the three-channel eta and k must give.
 */
static const struct {
    const char *name;
    float reflectance[3];
} exact[] = {
    {"Ag", {0.9889f, 0.9840f, 0.9775f}}, {"Al", {0.9079f, 0.9158f, 0.9226f}},
    {"Au", {1.0070f, 0.7331f, 0.3592f}}, {"Be", {0.5383f, 0.5355f, 0.5354f}},
    {"Bi", {0.5589f, 0.5307f, 0.4832f}}, {"Co", {0.6809f, 0.6555f, 0.6146f}},
    {"Cr", {0.5504f, 0.5559f, 0.5537f}}, {"Cu", {0.9125f, 0.6229f, 0.5179f}},
    {"Fe", {0.5286f, 0.5133f, 0.4934f}}, {"Hg", {0.7813f, 0.7795f, 0.7783f}},
    {"Ir", {0.7439f, 0.7320f, 0.6994f}}, {"Mg", {0.9560f, 0.9533f, 0.9502f}},
    {"Mo", {0.5734f, 0.5844f, 0.5824f}}, {"Nb", {0.5010f, 0.5072f, 0.5003f}},
    {"Ni", {0.6928f, 0.6410f, 0.5604f}}, {"Pb", {0.6575f, 0.6606f, 0.6943f}},
    {"Pd", {0.7299f, 0.6973f, 0.6507f}}, {"Pt", {0.6747f, 0.6381f, 0.5818f}},
    {"Rh", {0.7945f, 0.7647f, 0.7424f}}, {"Ti", {0.6155f, 0.5797f, 0.5417f}},
    {"V", {0.5213f, 0.5346f, 0.5675f}},  {"W", {0.5145f, 0.4964f, 0.4664f}},
    {"Zn", {0.8746f, 0.8690f, 0.8545f}}, {"Zr", {0.5824f, 0.5730f, 0.5330f}},
};

/* Fresnel's equations at normal incidence. */
static double reflectance(const struct brdf_metal *metal, int channel)
{
    double n = (double)metal->eta[channel], k = (double)metal->k[channel];
    return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

static void metals_have_their_colour(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof exact / sizeof exact[0]; ++i) {
        const struct brdf_metal *metal = brdf_metal_find(exact[i].name);
        assert_non_null(metal);
        for (int c = 0; c < 3; ++c) {
            /* Gold's red is outside of Rec. 709, and no eta and k reflect more than 1. */
            double expected = fmin((double)exact[i].reflectance[c], 1.0);
            double tolerance = exact[i].reflectance[c] > 1.0f ? 0.004 : 0.0003;
            if (fabs(reflectance(metal, c) - expected) > tolerance) {
                fail_msg("%s, channel %d: %g, not %g", metal->name, c, reflectance(metal, c),
                         expected);
            }
        }
    }
}

static void every_metal_is_tested(void **state)
{
    (void)state;
    int count = 0;
    while (brdf_metal_at(count)) {
        assert_ptr_equal(brdf_metal_find(brdf_metal_at(count)->name), brdf_metal_at(count));
        ++count;
    }
    assert_int_equal(count, sizeof exact / sizeof exact[0] + 1); /* and "none" */
    assert_null(brdf_metal_at(-1));
    for (int c = 0; c < 3; ++c) {
        assert_true(reflectance(brdf_metal_find("none"), c) == 1.0);
    }
}

static void names_of_metals(void **state)
{
    (void)state;
    assert_null(brdf_metal_find("cu"));
    assert_null(brdf_metal_find(""));
    assert_string_equal(brdf_metal_nearest("cu"), "Cu");
    assert_string_equal(brdf_metal_nearest("nne"), "none");
    assert_null(brdf_metal_nearest("unobtanium"));
}

static void dielectrics_by_name(void **state)
{
    (void)state;
    assert_true(brdf_dielectric_find("bk7")->ior == 1.5046f);
    assert_true(brdf_dielectric_find("water")->ior == 1.3330f);
    assert_true(brdf_dielectric_find("diamond")->ior == 2.419f);
    assert_true(brdf_dielectric_find("vacuum")->ior == 1.0f);
    assert_null(brdf_dielectric_find("Water"));
    assert_string_equal(brdf_dielectric_nearest("waterice"), "water ice");
    int count = 0;
    for (; brdf_dielectric_at(count); ++count) {
        float ior = brdf_dielectric_at(count)->ior;
        assert_true(ior >= 1.0f && ior < 3.0f);
        assert_true(count == 0 || strcmp(brdf_dielectric_at(count - 1)->name,
                                         brdf_dielectric_at(count)->name) < 0);
    }
    assert_true(count > 20);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(metals_have_their_colour),
        cmocka_unit_test(every_metal_is_tested),
        cmocka_unit_test(names_of_metals),
        cmocka_unit_test(dielectrics_by_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
