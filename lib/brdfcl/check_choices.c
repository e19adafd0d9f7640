/*
 * check_choices.c - the variants of a model: all combinations of its options, or a selection in
 * which any two options meet.
 *
 * Faults hide where two options meet rather than three, and combinations multiply: 144 kernels of
 * one model would take longer to compile than all others together.
 */
#include "check_cases.h"

#include <string.h>

enum { CHOICES = 8, OPTIONS = 16, COMBINATIONS = 1024, ALL_UP_TO = 16 };

struct choices {
    int count;
    int options[CHOICES];
    unsigned combination[COMBINATIONS]; /* 4 bits a choice, as in a material */
    int combinations;
    unsigned short met[CHOICES][OPTIONS][CHOICES]; /* with which options, a bit each */
};

static int option_of(unsigned combination, int choice)
{
    return (int)(combination >> 4 * choice & 15u);
}

static void list_options(struct choices *c, const struct brdf_model_info *model)
{
    char item[64];
    c->count = 0;
    for (size_t i = 0; i < model->parameter_count; ++i) {
        if (model->parameters[i].kind == BRDF_KIND_CHOICE) {
            int *options = &c->options[c->count++];
            *options = 0;
            while (brdf_parameter_item(&model->parameters[i], *options, item, sizeof item)) {
                ++*options;
            }
        }
    }
}

/* Every combination that is allowed, the first choice fastest. */
static void list_combinations(struct choices *c, const struct brdf_model_info *model)
{
    char reason[300];
    int total = 1;
    for (int k = 0; k < c->count; ++k) {
        total *= c->options[k];
    }
    c->combinations = 0;
    for (int number = 0; number < total && c->combinations < COMBINATIONS; ++number) {
        unsigned combination = 0;
        for (int k = 0, rest = number; k < c->count; rest /= c->options[k], ++k) {
            combination |= (unsigned)(rest % c->options[k]) << 4 * k;
        }
        if (!brdf_choices_refused(model, combination, reason, sizeof reason)) {
            c->combination[c->combinations++] = combination;
        }
    }
}

/* How many pairs of options this combination has that have not met before; then they have. */
static int new_pairs(struct choices *c, unsigned combination, int keep)
{
    int count = 0;
    for (int a = 0; a < c->count; ++a) {
        for (int b = 0; b < a; ++b) {
            unsigned short *met = &c->met[a][option_of(combination, a)][b];
            unsigned short bit = (unsigned short)(1u << option_of(combination, b));
            count += !(*met & bit);
            if (keep) {
                *met = (unsigned short)(*met | bit);
            }
        }
    }
    return count;
}

/* Of many combinations keep, again and again, the one in which most pairs meet that have not. */
static void select_combinations(struct choices *c)
{
    unsigned chosen[COMBINATIONS];
    int count = 0;
    int most = 1;
    memset(c->met, 0, sizeof c->met);
    while (most > 0) {
        int best = 0;
        most = 0;
        for (int i = 0; i < c->combinations; ++i) {
            int pairs = new_pairs(c, c->combination[i], 0);
            best = pairs > most ? i : best;
            most = pairs > most ? pairs : most;
        }
        if (most > 0) {
            new_pairs(c, c->combination[best], 1);
            chosen[count++] = c->combination[best];
        }
    }
    memcpy(c->combination, chosen, (size_t)count * sizeof *chosen);
    c->combinations = count;
}

static void list_variants(struct choices *c, const struct brdf_model_info *model)
{
    list_options(c, model);
    list_combinations(c, model);
    if (c->combinations > ALL_UP_TO) {
        select_combinations(c);
    }
}

int brdfcl_check_variant_count(const struct brdf_model_info *model)
{
    struct choices c;
    list_variants(&c, model);
    int may_mirror = !(model->flags & BRDF_TRANSMISSION);
    return c.combinations == 1 && may_mirror ? 2 : c.combinations;
}

void brdfcl_check_material_vary(struct brdf_material *material, const struct brdf_model_info *model,
                                int variant)
{
    struct choices c;
    list_variants(&c, model);
    unsigned own = 0u; /* what is DECIDED stays */
    for (int k = 0; k < c.count; ++k) {
        own |= 15u << 4 * k;
    }
    material->choices = (material->choices & ~own) | c.combination[variant % c.combinations];
    int sum = variant / c.combinations;
    for (int k = 0; k < c.count; ++k) {
        sum += option_of(material->choices, k);
    }
    /* Mirroring is for one-sided models; one that transmits has its own other side. */
    material->flags &= ~BRDF_TWOSIDED;
    if (!(model->flags & BRDF_TRANSMISSION) && sum % 2) {
        material->flags |= BRDF_TWOSIDED;
    }
}
