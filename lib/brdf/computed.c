/*
 * computed.c - the table of a model that has no files: what its surface loses, and lets through.
 */
#include "brdf/microfacet.h"
#include "brdf/round.h"
#include "bsdf.h"
#include "brushed_table.h"
#include "glass_table.h"

/* What a table is made for, and where it goes. */
struct computing {
    struct brdf_material *material;
    unsigned varies; /* words of the material that will have other values */
    int fixed;       /* 0: any word may */
    float **table;
    size_t *words;
    struct brdf_error *error;
};

int brdf_option_of(const struct brdf_material *material, const char *name)
{
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    const struct brdf_parameter_info *p = brdf_parameter_find(model, name);
    return p ? (int)(material->choices >> 4 * brdf_parameter_place(model, p) & 15u) : 0;
}

static int word_of(const struct brdf_material *material, const char *name)
{
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    return brdf_parameter_place(model, brdf_parameter_find(model, name));
}

static double value_of(const struct brdf_material *material, const char *name)
{
    return (double)material->word[word_of(material, name)];
}

/* What is DECIDED lies behind the choices. */
static void decide(struct brdf_material *material, int yes)
{
    const struct brdf_model_info *model = brdf_model_info((int)material->model);
    int place = 0;
    for (size_t i = 0; i < model->parameter_count; ++i) {
        place += model->parameters[i].kind == BRDF_KIND_CHOICE;
    }
    material->choices &= ~(15u << 4 * place);
    material->choices |= (unsigned)yes << 4 * place;
}

/* Index of what is below over that above. */
static double eta_of(const struct brdf_material *material)
{
    return (double)(material->word[word_of(material, "int_ior")] /
                    material->word[word_of(material, "ext_ior")]);
}

/* A surface with a roughness along each tangent. */
static struct facet_surface surface_of(const struct brdf_material *material)
{
    struct facet_surface surface = {
        brdf_option_of(material, "distribution"), brdf_option_of(material, "masking"),
        value_of(material, "alpha_u"), value_of(material, "alpha_v"), 0.0};
    return surface;
}

/* Whether its two roughnesses differ and are the same everywhere: then a table is for them alone.
 */
static int is_brushed(const struct computing *c, const struct facet_surface *surface)
{
    unsigned words = 1u << word_of(c->material, "alpha_u") | 1u << word_of(c->material, "alpha_v");
    return surface->alpha_u != surface->alpha_v && !(c->varies & words);
}

/* What metals lose whose roughnesses are the same is a fit (brdf/energy.h). */
static brdf_status metal_compute(const struct computing *c)
{
    struct facet_surface surface = surface_of(c->material);
    int brushed = is_brushed(c, &surface);
    decide(c->material, brushed);
    return brushed ? brdf_brushed_table_make(&surface, c->table, c->words, c->error) : BRDF_OK;
}

static brdf_status glass_compute(const struct computing *c)
{
    struct facet_surface surface = surface_of(c->material);
    int brushed = is_brushed(c, &surface);
    surface.eta = eta_of(c->material);
    decide(c->material, brushed);
    if (brushed) {
        return brdf_brushed_glass_table_make(&surface, c->table, c->words, c->error);
    }
    float alpha =
        brdf_round_make(BRDF_ROUND_SMITH, (float)surface.alpha_u, (float)surface.alpha_v).alpha;
    surface.alpha_u = surface.alpha_v = c->fixed ? (double)alpha : 0.0;
    return brdf_glass_table_make(&surface, 0, c->table, c->words, c->error);
}

static brdf_status coating_compute(const struct computing *c)
{
    double alpha = c->fixed ? value_of(c->material, "alpha") : 0.0;
    struct facet_surface surface = {brdf_option_of(c->material, "distribution"),
                                    BRDF_MASKING_SEPARABLE, alpha, alpha, eta_of(c->material)};
    return brdf_glass_table_make(&surface, 1, c->table, c->words, c->error);
}

/* The models that are BRDF_COMPUTED, and the option without which they need no table. */
static const struct {
    int model;
    const char *option; /* NULL: always */
    brdf_status (*compute)(const struct computing *computing);
} makers[] = {
    {BRDF_MODEL_ROUGHCONDUCTOR, "multiscatter", metal_compute},
    {BRDF_MODEL_ROUGHDIELECTRIC, "multiscatter", glass_compute},
    {BRDF_MODEL_ROUGHPLASTIC, NULL, coating_compute},
};

brdf_status brdf_table_compute(struct brdf_material *material, unsigned varies, int fixed,
                               float **table, size_t *words, struct brdf_error *error)
{
    const struct computing computing = {material, varies, fixed, table, words, error};
    for (size_t i = 0; i < sizeof makers / sizeof makers[0]; ++i) {
        const char *option = makers[i].option;
        if (makers[i].model == (int)material->model) {
            int needed = !option || brdf_option_of(material, option);
            return needed ? makers[i].compute(&computing) : BRDF_OK;
        }
    }
    return brdf_fail(error, BRDF_UNSUPPORTED, "%s: nothing computes its table",
                     brdf_model_info((int)material->model)->name);
}
