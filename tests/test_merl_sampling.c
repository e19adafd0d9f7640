/*
 * test_merl_sampling.c - the model merl: energy, density and variance of its sampling.
 */
#define _XOPEN_SOURCE 700

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>

#include <unistd.h>

#include "merl_tables.h"

/* A gray Lambertian surface is its own floor: cosine sampling, every weight the albedo. */
static void baked_lambert_reflects_its_albedo(void **state)
{
    struct baked *baked = *state;
    struct brdfcl_random random = {4};
    for (int i = 0; i < 100000; ++i) {
        brdf_vec3 wo = random_above(&random), wi = random_above(&random);
        brdf_rgb f = brdf_merl_eval(material(i % 2), wo, wi, baked->gray);
        assert_float_equal(f.r, (float)(gray_albedo / pi), 1e-6f);
        struct brdf_sample s =
            brdf_merl_sample(material(i % 2), wo, random_cube(&random), baked->gray);
        assert_float_equal(s.weight.g, (float)gray_albedo, 2e-6f);
    }
}

/* What sample returns is what eval and pdf say of it. */
static void weights_are_f_cos_over_pdf(void **state)
{
    struct baked *baked = *state;
    struct brdfcl_random random = {5};
    for (int i = 0; i < 200000; ++i) {
        brdf_vec3 wo = random_above(&random);
        struct brdf_sample s =
            brdf_merl_sample(material(0), wo, random_cube(&random), baked->glossy);
        if (s.pdf == 0.0f) {
            assert_true(s.weight.r == 0.0f);
            continue;
        }
        assert_true(s.wi.z > 0.0f);
        assert_float_equal(brdf_dot(s.wi, s.wi), 1.0f, 2e-6f);
        double pdf = (double)brdf_merl_pdf(material(0), wo, s.wi, baked->glossy);
        brdf_rgb f = brdf_merl_eval(material(0), wo, s.wi, baked->glossy);
        assert_true(fabs(pdf / (double)s.pdf - 1.0) < 1e-6);
        double wanted = (double)f.b * (double)s.wi.z / pdf;
        assert_true(fabs((double)s.weight.b - wanted) <= 1e-5 * wanted);
    }
}

/* Mean and relative variance of an estimate of the albedo. */
struct estimate {
    double mean;
    double variance;
};

static struct estimate albedo_estimate(const float *table, double degrees, int cosine)
{
    enum { COUNT = 100000 };
    struct brdfcl_random random = {6};
    brdf_vec3 wo = direction(degrees);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < COUNT; ++i) {
        brdf_vec3 u = random_cube(&random);
        double weight =
            cosine ? pi * mean(brdf_merl_eval(material(0), wo, brdf_warp_cosine(u.x, u.y), table))
                   : mean(brdf_merl_sample(material(0), wo, u, table).weight);
        sum += weight / COUNT;
        squares += weight * weight / COUNT;
    }
    struct estimate estimate = {sum, (squares - sum * sum) / (sum * sum)};
    return estimate;
}

/* Both estimates agree within their noise, and ours has far less of it. */
static void sampling_follows_the_lobe(void **state)
{
    struct baked *baked = *state;
    for (int i = 0; i < INCIDENCES; ++i) {
        struct estimate ours = albedo_estimate(baked->glossy, incidences[i], 0);
        struct estimate plain = albedo_estimate(baked->glossy, incidences[i], 1);
        double noise = sqrt((ours.variance + plain.variance) / 1e5);
        assert_true(fabs(ours.mean / plain.mean - 1.0) < 5.0 * noise);
        assert_true(ours.variance < 0.1 * plain.variance);
    }
}

/* A black material, all of whose tables would divide by 0. */
static void black_is_sampled_too(void **state)
{
    (void)state;
    float *black = bake(test_lambert, 0.0);
    assert_non_null(black);
    struct brdf_sample s =
        brdf_merl_sample(material(0), direction(40.0), brdf_vec3_make(0.3f, 0.6f, 0.9f), black);
    assert_true(s.pdf > 0.0f && s.weight.r == 0.0f && s.weight.b == 0.0f);
    free(black);
}

/*
 * Counts of samples over a grid of theta_i and phi_i, against the density integrated over each
 * cell: mass and chi-square in one go. The samples that are lost below the surface are too few to
 * make a cell of: their share is compared to the missing mass. The sum over a cell is fine in
 * theta, for the density jumps at the edges of the rings of theta_h.
 */
enum { GRID_THETA = 20, GRID_PHI = 40, FINE_THETA = 100, FINE_PHI = 8, SAMPLES = 1000000 };
enum { CELL_COUNT = GRID_THETA * GRID_PHI };

static double cell_mass(const float *table, brdf_vec3 wo, int cell)
{
    double sum = 0.0;
    double step = 0.5 * pi / (GRID_THETA * FINE_THETA);
    double turn = 2.0 * pi / (GRID_PHI * FINE_PHI);
    for (int k = 0; k < FINE_THETA * FINE_PHI; ++k) {
        double theta = step * (cell / GRID_PHI * FINE_THETA + k / FINE_PHI + 0.5);
        double phi = turn * (cell % GRID_PHI * FINE_PHI + k % FINE_PHI + 0.5);
        double r = sin(theta);
        brdf_vec3 wi =
            brdf_vec3_make((float)(r * cos(phi)), (float)(r * sin(phi)), (float)cos(theta));
        sum += (double)brdf_merl_pdf(material(0), wo, wi, table) * r;
    }
    return sum * step * turn;
}

static int grid_cell(brdf_vec3 wi)
{
    double flat = sqrt((double)wi.x * (double)wi.x + (double)wi.y * (double)wi.y);
    double theta = atan2(flat, (double)wi.z) / (0.5 * pi);
    double phi = atan2((double)wi.y, (double)wi.x) / (2.0 * pi);
    int row = (int)(theta * GRID_THETA);
    int column = (int)((phi < 0.0 ? phi + 1.0 : phi) * GRID_PHI);
    return (row < GRID_THETA ? row : GRID_THETA - 1) * GRID_PHI + column % GRID_PHI;
}

/* The chance of a chi-square at least this large, by Wilson and Hilferty's normal approximation. */
static double chi_square_chance(double value, int freedom)
{
    double spread = 2.0 / (9.0 * freedom);
    double z = (pow(value / freedom, 1.0 / 3.0) - (1.0 - spread)) / sqrt(spread);
    return 0.5 * erfc(z / sqrt(2.0));
}

/* The part of all samples that is above the surface, and their counts by cell. */
static double samples_count(const float *table, brdf_vec3 wo, unsigned seed, int *counted)
{
    int above = 0;
    struct brdfcl_random random = {seed};
    memset(counted, 0, sizeof(int) * CELL_COUNT);
    for (int i = 0; i < SAMPLES; ++i) {
        struct brdf_sample s = brdf_merl_sample(material(0), wo, random_cube(&random), table);
        if (s.pdf > 0.0f) {
            ++counted[grid_cell(s.wi)];
            ++above;
        }
    }
    return (double)above / SAMPLES;
}

static void samples_have_the_density_of_pdf(void **state)
{
    struct baked *baked = *state;
    static int counted[CELL_COUNT];
    for (int n = 0; n < INCIDENCES; ++n) {
        brdf_vec3 wo = direction(incidences[n]);
        double above = samples_count(baked->glossy, wo, 7 + (unsigned)n, counted);
        double mass = 0.0, chi_square = 0.0, expected = 0.0;
        int freedom = -1, pooled = 0;
        for (int cell = 0; cell < CELL_COUNT; ++cell) {
            double part = cell_mass(baked->glossy, wo, cell);
            mass += part;
            expected += part * SAMPLES;
            pooled += counted[cell];
            if (expected >= 5.0) { /* fewer are pooled with the next cell */
                chi_square += (pooled - expected) * (pooled - expected) / expected;
                ++freedom;
                expected = 0.0;
                pooled = 0;
            }
        }
        double chance = chi_square_chance(chi_square, freedom);
        print_message("    %2.0f degrees: mass %.5f, chi-square %.1f of %d, p = %.3g\n",
                      incidences[n], mass, chi_square, freedom, chance);
        assert_true(mass < 1.001 && mass > 0.95);
        assert_true(fabs(mass - above) < 5e-4);
        assert_true(chance > 1e-4);
    }
}

/* Measured data where it is at hand: figures of the material, and what the sampling is for. */
static void a_real_material_is_plausible(void **state)
{
    (void)state;
    const char *data = getenv("BRDFCL_DATA") ? getenv("BRDFCL_DATA") : "../shared/data";
    char packed[4096], command[5000];
    snprintf(packed, sizeof packed, "%s/merl/gold-metallic-paint.binary.xz", data);
    if (access(packed, R_OK) != 0 || system("xz --version >/dev/null 2>&1") != 0) {
        print_message("    skipped, no data\n");
        skip();
    }
    struct place place;
    float *table = NULL;
    size_t words;
    assert_int_equal(place_make(&place, "gold.binary"), 0);
    snprintf(command, sizeof command, "xz -dc '%s' >'%s'", packed, place.path);
    int unpacked = system(command);
    brdf_status status =
        brdf_merl_table_load(place.path, BRDF_MERL_INVALID_FILL, &table, &words, NULL);
    place_remove(&place);
    assert_int_equal(unpacked, 0);
    assert_int_equal(status, BRDF_OK);
    for (int i = 0; i < 3; ++i) {
        struct estimate ours = albedo_estimate(table, incidences[i], 0);
        struct estimate plain = albedo_estimate(table, incidences[i], 1);
        print_message("    %2.0f degrees: albedo %.4f, variance %.4f; by the cosine %.4f\n",
                      incidences[i], ours.mean, ours.variance, plain.variance);
        assert_true(ours.mean > 0.10 && ours.mean < 0.18);
        assert_true(fabs(ours.mean / plain.mean - 1.0) < 0.03);
        assert_true(ours.variance < 0.05 * plain.variance);
    }
    free(table);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(baked_lambert_reflects_its_albedo),
        cmocka_unit_test(weights_are_f_cos_over_pdf),
        cmocka_unit_test(sampling_follows_the_lobe),
        cmocka_unit_test(black_is_sampled_too),
        cmocka_unit_test(samples_have_the_density_of_pdf),
        cmocka_unit_test(a_real_material_is_plausible),
    };
    return cmocka_run_group_tests(tests, tables_make, tables_free);
}
