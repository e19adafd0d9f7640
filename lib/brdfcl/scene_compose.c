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
    int parts;                 /* so far */
};

static brdf_status compose_any(struct composer *composer, struct xml_node *node, int *reference);

static int compose_is(const struct xml_node *node, const char *type)
{
    return strcmp(xml_attribute_get(node, "type"), type) == 0;
}

/* The fork, equal ones being one. */
static brdf_status compose_fork(struct composer *composer, const struct xml_node *node,
                                struct scene_fork wanted, int *reference)
{
    struct scene_loader *loader = composer->loader;
    struct brdfcl_scene *scene = loader->scene;
    if (!composer->radiance) {
        return BRDF_OK;
    }
    for (size_t i = 0; i < scene->fork_count; ++i) {
        if (memcmp(&scene->forks[i], &wanted, sizeof wanted) == 0) {
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
    scene->forks[scene->fork_count] = wanted;
    *reference = -1 - (int)scene->fork_count++;
    return BRDF_OK;
}

/* The surface of a bsdf, or of nothing at all (NULL). */
static brdf_status compose_surface(struct composer *composer, const struct xml_node *node,
                                   struct brdf_bsdf *bsdf, int *reference)
{
    return composer->radiance
               ? scene_surface_add(composer->loader, node, bsdf, composer->radiance, reference)
               : BRDF_OK;
}

/* The nested bsdfs, exactly `count`. */
static brdf_status compose_children(const struct composer *composer, const struct xml_node *node,
                                    struct xml_node **children, int count)
{
    struct xml_node *cursor = NULL;
    struct xml_node *child;
    int found = 0;
    while ((child = scene_object_next(composer->loader, node, "bsdf", &cursor)) != NULL) {
        if (found == count) {
            return scene_fail(composer->loader, cursor, BRDF_BAD_FILE,
                              "a %s holds %s, this is one more", xml_attribute_get(node, "type"),
                              count == 1 ? "one <bsdf>" : "two <bsdf>s");
        }
        children[found++] = child;
    }
    if (found < count) {
        return scene_fail(composer->loader, node, BRDF_BAD_FILE, "a %s holds %s, not %s",
                          xml_attribute_get(node, "type"),
                          count == 1 ? "one <bsdf>" : "two <bsdf>s", found ? "one" : "none");
    }
    return BRDF_OK;
}

static brdf_status compose_blend(struct composer *composer, struct xml_node *node, int *reference)
{
    struct scene_loader *loader = composer->loader;
    struct xml_node *children[2];
    struct scene_fork fork = {0, 0, 0.0f};
    double weight = 0.0;
    struct scene_slot slots[] = {{"weight", SLOT_REAL, &weight, 0.0, 1.0, NULL}};
    brdf_status status = scene_slots_read(loader, node, slots, 1, "bsdf");
    if (!status && !slots[0].given) {
        status = scene_fail(loader, node, BRDF_BAD_FILE,
                            "a blendbsdf needs a weight: the share of its second bsdf, 0 to 1");
    }
    if (!status) {
        status = compose_children(composer, node, children, 2);
    }
    if (!status) {
        status = compose_any(composer, children[0], &fork.first);
    }
    if (!status) {
        status = compose_any(composer, children[1], &fork.second);
    }
    fork.weight = (float)weight;
    return status ? status : compose_fork(composer, node, fork, reference);
}

/* A blend of nothing and the nested bsdf. */
static brdf_status compose_mask(struct composer *composer, struct xml_node *node, int *reference)
{
    struct scene_loader *loader = composer->loader;
    struct xml_node *child;
    struct scene_fork fork = {0, 0, 0.0f};
    double opacity = 0.5;
    struct scene_slot slots[] = {{"opacity", SLOT_REAL, &opacity, 0.0, 1.0, NULL}};
    brdf_status status = scene_slots_read(loader, node, slots, 1, "bsdf");
    if (!status && composer->twosided) {
        status = scene_fail(loader, node, BRDF_UNSUPPORTED,
                            "a mask in a twosided; put the twosided into the mask");
    }
    if (!status) {
        status = compose_children(composer, node, &child, 1);
    }
    if (!status) {
        status = compose_surface(composer, node, NULL, &fork.first);
    }
    if (!status) {
        status = compose_any(composer, child, &fork.second);
    }
    fork.weight = (float)opacity;
    return status ? status : compose_fork(composer, node, fork, reference);
}

static brdf_status compose_twosided(struct composer *composer, struct xml_node *node,
                                    int *reference)
{
    struct xml_node *child;
    brdf_status status = scene_slots_read(composer->loader, node, NULL, 0, "bsdf");
    if (!status && composer->twosided) {
        status = scene_fail(composer->loader, node, BRDF_BAD_FILE, "twosided in twosided");
    }
    if (!status) {
        status = compose_children(composer, node, &child, 1);
    }
    if (!status) {
        composer->twosided = node;
        status = compose_any(composer, child, reference);
        composer->twosided = NULL;
    }
    return status;
}

static brdf_status compose_any(struct composer *composer, struct xml_node *node, int *reference)
{
    struct brdf_bsdf *bsdf = NULL;
    brdf_status status;
    if (++composer->parts > COMPOSE_MAX) {
        return scene_fail(composer->loader, node, BRDF_UNSUPPORTED, "a bsdf of more than %d parts",
                          COMPOSE_MAX);
    }
    if (compose_is(node, "blendbsdf")) {
        return compose_blend(composer, node, reference);
    }
    if (compose_is(node, "mask")) {
        return compose_mask(composer, node, reference);
    }
    if (compose_is(node, "twosided")) {
        return compose_twosided(composer, node, reference);
    }
    status = scene_bsdf_read(composer->loader, node, composer->twosided, &bsdf);
    return status ? status : compose_surface(composer, node, bsdf, reference);
}

brdf_status scene_compose_read(struct scene_loader *loader, struct xml_node *node,
                               const double radiance[3], int *reference)
{
    struct composer composer = {loader, radiance, NULL, 0};
    return compose_any(&composer, node, reference);
}
