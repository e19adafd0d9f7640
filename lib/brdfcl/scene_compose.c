/*
 * scene_compose.c - what a shape's <bsdf> becomes: a surface, or forks that lead to several.
 *
 * A part of the shape's light is decided for at random (kernels/resolve.h), so each part is a
 * surface of its own, and "blendbsdf" and "mask" are the forks that lead to it. "twosided" holds
 * for all parts inside.
 */
#include "scene_loader.h"

#include <stdlib.h>
#include <string.h>

#include <brdf/model.h>

/* Bsdfs that a shape's bsdf may consist of. Blends of blends that share their parts double with
   each, and a short file could ask for any number. */
#define COMPOSE_MAX 1000

/* What holds for all parts of a composition. */
struct composer {
    struct scene_loader *loader;
    const double *radiance;    /* that each part emits; NULL: check only, make nothing */
    struct xml_node *twosided; /* the one around, or NULL */
    struct xml_node *tilted;   /* the normalmap or bumpmap around, or NULL */
    struct scene_tilt tilt;    /* what it says */
    int parts;                 /* so far */
};

static brdf_status compose_any(struct composer *composer, struct xml_node *node, int *reference);

/* The fork, equal ones being one. */
static brdf_status compose_fork(struct composer *composer, const struct xml_node *node,
                                const struct scene_fork *wanted, int *reference)
{
    struct scene_loader *loader = composer->loader;
    struct brdfcl_scene *scene = loader->scene;
    if (!composer->radiance) {
        return BRDF_OK;
    }
    for (size_t i = 0; i < scene->fork_count; ++i) {
        if (memcmp(&scene->forks[i], wanted, sizeof *wanted) == 0) {
            *reference = -1 - (int)i;
            return BRDF_OK;
        }
    }
    if (scene->fork_count == loader->fork_capacity) {
        size_t capacity = 2 * loader->fork_capacity + 8;
        struct scene_fork *forks = realloc(scene->forks, capacity * sizeof *forks);
        if (!forks) {
            return scene_fail_memory(loader, node);
        }
        scene->forks = forks;
        loader->fork_capacity = capacity;
    }
    scene->forks[scene->fork_count] = *wanted;
    *reference = -1 - (int)scene->fork_count++;
    return BRDF_OK;
}

/* The surface of a bsdf, or of nothing at all (NULL). */
static brdf_status compose_surface(struct composer *composer, const struct xml_node *node,
                                   struct brdf_bsdf *bsdf, int *reference)
{
    return composer->radiance ? scene_surface_add(composer->loader, node, bsdf, &composer->tilt,
                                                  composer->radiance, reference)
                              : BRDF_OK;
}

static brdf_status compose_model(struct composer *composer, struct xml_node *node, int *reference)
{
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status = scene_bsdf_read(composer->loader, node, composer->twosided, &bsdf);
    /* Where the map has a frame for each side, the bsdf has a front only; but it must be one that
       can be twosided, which was asked just now. */
    if (!status && composer->tilt.how & PT_TILT_TWOSIDED) {
        status = scene_bsdf_read(composer->loader, node, NULL, &bsdf);
    }
    return status ? status : compose_surface(composer, node, bsdf, reference);
}

/* The nested bsdfs, `least` to `most` of them. */
static brdf_status compose_children(const struct composer *composer, const struct xml_node *node,
                                    struct xml_node **children, int least, int most)
{
    static const char *const counts[] = {"none", "one", "two"};
    const char *type = xml_attribute_get(node, "type");
    struct xml_node *cursor = NULL;
    struct xml_node *child;
    int found = 0;
    while ((child = scene_object_next(composer->loader, node, "bsdf", &cursor)) != NULL) {
        if (found == most) {
            return scene_fail(composer->loader, cursor, BRDF_BAD_FILE,
                              "a %s holds %s <bsdf>; this is one more", type, counts[most]);
        }
        children[found++] = child;
    }
    if (found < least) {
        return scene_fail(composer->loader, node, BRDF_BAD_FILE, "a %s holds %s <bsdf>, not %s",
                          type, counts[least], counts[found]);
    }
    return BRDF_OK;
}

/* The parameter of a fork: a number from 0 to 1, or a texture. */
static brdf_status compose_share(struct composer *composer, struct xml_node *node, const char *name,
                                 int required, struct scene_fork *fork)
{
    struct scene_loader *loader = composer->loader;
    const struct xml_node *texture = NULL;
    double share = 0.5;
    struct scene_slot slot = {name, SLOT_REAL, &share, 0.0, 1.0, NULL};
    brdf_status status = scene_slots_read(loader, node, &slot, 1, "bsdf|texture");
    if (!status) {
        status = scene_texture_child(loader, node, name, &texture, &fork->texture);
    }
    if (!status && texture && slot.given) {
        status = scene_fail(loader, texture, BRDF_BAD_FILE, "%s is given already, in line %d", name,
                            slot.given->line);
    }
    if (!status && required && !texture && !slot.given) {
        status = scene_fail(loader, node, BRDF_BAD_FILE,
                            "a %s needs a %s, 0 to 1: the share of its second bsdf",
                            xml_attribute_get(node, "type"), name);
    }
    if (!status && texture) {
        fork->kind = PT_FORK_TEXTURE;
        const struct pt_binding range = {
            fork->texture, loader->scene->textures[fork->texture].record.output, 0.0f, 1.0f};
        return scene_texture_check(loader, texture, &range, name);
    }
    fork->kind = PT_FORK_SHARE;
    fork->weight = (float)share;
    return status;
}

/* Both ways of a fork, and the fork. */
static brdf_status compose_both(struct composer *composer, struct xml_node *node,
                                struct xml_node *const *children, struct scene_fork *fork,
                                int *reference)
{
    brdf_status status = compose_any(composer, children[0], &fork->first);
    if (!status) {
        status = compose_any(composer, children[1], &fork->second);
    }
    return status ? status : compose_fork(composer, node, fork, reference);
}

static brdf_status compose_blend(struct composer *composer, struct xml_node *node, int *reference)
{
    struct xml_node *children[2];
    struct scene_fork fork = {0, 0, 0, 0, 0.0f};
    brdf_status status = compose_share(composer, node, "weight", 1, &fork);
    if (!status) {
        status = compose_children(composer, node, children, 2, 2);
    }
    return status ? status : compose_both(composer, node, children, &fork, reference);
}

/* A blend of nothing and the nested bsdf. */
static brdf_status compose_mask(struct composer *composer, struct xml_node *node, int *reference)
{
    struct xml_node *around = composer->twosided ? composer->twosided : composer->tilted;
    struct xml_node *child;
    struct scene_fork fork = {0, 0, 0, 0, 0.0f};
    brdf_status status = compose_share(composer, node, "opacity", 0, &fork);
    if (!status && around) {
        const char *type = xml_attribute_get(around, "type");
        status = scene_fail(composer->loader, node, BRDF_UNSUPPORTED,
                            "a mask in a %s; put the %s into the mask", type, type);
    }
    if (!status) {
        status = compose_children(composer, node, &child, 1, 1);
    }
    if (!status) {
        status = compose_surface(composer, node, NULL, &fork.first);
    }
    if (!status) {
        status = compose_any(composer, child, &fork.second);
    }
    return status ? status : compose_fork(composer, node, &fork, reference);
}

/* Around one bsdf: both sides look like its front. Around two: the first is the front, the second
   the back. */
static brdf_status compose_twosided(struct composer *composer, struct xml_node *node,
                                    int *reference)
{
    struct xml_node *children[2] = {NULL, NULL};
    struct scene_fork fork = {0, 0, PT_FORK_SIDE, 0, 0.0f};
    brdf_status status = scene_slots_read(composer->loader, node, NULL, 0, "bsdf");
    if (!status && composer->twosided) {
        status = scene_fail(composer->loader, node, BRDF_BAD_FILE, "twosided in twosided");
    }
    if (!status) {
        status = compose_children(composer, node, children, 1, 2);
    }
    if (!status && children[1] && composer->tilted) {
        const char *type = xml_attribute_get(composer->tilted, "type");
        status =
            scene_fail(composer->loader, node, BRDF_UNSUPPORTED,
                       "a twosided with two sides in a %s; put a %s into each side", type, type);
    }
    if (status) {
        return status;
    }
    composer->twosided = node;
    status = children[1] ? compose_both(composer, node, children, &fork, reference)
                         : compose_any(composer, children[0], reference);
    composer->twosided = NULL;
    return status;
}

static brdf_status compose_tilt(struct composer *composer, struct xml_node *node, int *reference)
{
    const struct scene_tilt none = {0u, 0, 0.0f};
    struct xml_node *child;
    brdf_status status;
    if (composer->tilted) {
        return scene_fail(composer->loader, node, BRDF_UNSUPPORTED,
                          "a %s in a %s: one is supported", xml_attribute_get(node, "type"),
                          xml_attribute_get(composer->tilted, "type"));
    }
    status = scene_tilt_read(composer->loader, node, &composer->tilt);
    if (!status) {
        status = compose_children(composer, node, &child, 1, 1);
    }
    if (!status) {
        composer->tilt.how |= composer->twosided ? PT_TILT_TWOSIDED : 0u;
        composer->tilted = node;
        status = compose_any(composer, child, reference);
    }
    composer->tilted = NULL;
    composer->tilt = none;
    return status;
}

static brdf_status compose_any(struct composer *composer, struct xml_node *node, int *reference)
{
    static const struct {
        const char *type;
        brdf_status (*compose)(struct composer *composer, struct xml_node *node, int *reference);
    } plugins[] = {
        {"blendbsdf", compose_blend}, {"mask", compose_mask},    {"twosided", compose_twosided},
        {"normalmap", compose_tilt},  {"bumpmap", compose_tilt},
    };
    const char *type = xml_attribute_get(node, "type");
    if (++composer->parts > COMPOSE_MAX) {
        return scene_fail(composer->loader, node, BRDF_UNSUPPORTED, "a bsdf of more than %d parts",
                          COMPOSE_MAX);
    }
    for (size_t i = 0; i < sizeof plugins / sizeof plugins[0]; ++i) {
        if (strcmp(plugins[i].type, type) == 0) {
            return plugins[i].compose(composer, node, reference);
        }
    }
    return compose_model(composer, node, reference);
}

brdf_status scene_compose_read(struct scene_loader *loader, struct xml_node *node,
                               const double radiance[3], int *reference)
{
    struct composer composer = {loader, radiance, NULL, NULL, {0u, 0, 0.0f}, 0};
    return compose_any(&composer, node, reference);
}
