/*
 * world_forks.c - composed surfaces: the forks at which paths decide, and the keys of what they
 * meet.
 */
#include "world.h"

int world_key(const struct brdfcl_scene *scene, int reference)
{
    return reference < 0 ? (int)scene->surface_count - reference : reference;
}

brdf_status world_forks(const struct brdfcl_scene *scene, struct world *world,
                        struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    size_t fork_words = sizeof(struct pt_fork) / sizeof(float);
    settings->fork_count = (int)scene->fork_count;
    settings->features |= scene->fork_count > 0 ? PT_HAS_FORKS : 0;
    brdf_status status =
        world_append(words, NULL, scene->fork_count * fork_words, &settings->forks, error);
    for (size_t i = 0; i < scene->fork_count && status == BRDF_OK; ++i) {
        const struct scene_fork *from = &scene->forks[i];
        struct pt_fork *to = (struct pt_fork *)(void *)(words->words + settings->forks) + i;
        to->kind = from->kind;
        to->texture = from->texture;
        to->weight = from->weight;
        settings->features |= from->kind != PT_FORK_SHARE ? PT_HAS_PLACED_FORKS : 0;
        to->first = world_key(scene, from->first);
        to->second = world_key(scene, from->second);
    }
    return status;
}
