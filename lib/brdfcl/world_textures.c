/*
 * world_textures.c - textures with their texels, and which parameters they set.
 */
#include <string.h>

#include "image_formats.h"
#include "world.h"

/* The values of 8-bit texels, once for each of the two ways to read them. */
struct decoders {
    int first[2]; /* -1: not there yet */
};

static brdf_status put_decoder(struct decoders *decoders, int raw, struct world_words *words,
                               struct brdf_error *error)
{
    float values[256];
    if (decoders->first[raw] >= 0) {
        return BRDF_OK;
    }
    brdfcl_image_codes(raw, values);
    return world_append(words, values, 256, &decoders->first[raw], error);
}

static brdf_status put_texels(const struct scene_texture *texture, struct pt_texture *record,
                              struct decoders *decoders, struct world_words *words,
                              struct brdf_error *error)
{
    size_t texels = (size_t)record->width * (size_t)record->height;
    int raw = texture->raw != 0;
    brdf_status status;
    record->decode = -1;
    if (texture->codes) {
        status = put_decoder(decoders, raw, words, error);
        record->decode = decoders->first[raw];
        if (status == BRDF_OK) {
            status = world_append(words, NULL, texels, &record->texels, error);
        }
        if (status == BRDF_OK) {
            memcpy(words->words + record->texels, texture->codes, texels * sizeof(float));
        }
        return status;
    }
    status = world_append(words, NULL, texels * 4, &record->texels, error);
    for (size_t i = 0; i < texels && status == BRDF_OK; ++i) {
        memcpy(words->words + record->texels + 4 * i, texture->rgb + 3 * i, 3 * sizeof(float));
    }
    return status;
}

brdf_status world_textures(const struct brdfcl_scene *scene, struct world *world,
                           struct world_words *words, struct brdf_error *error)
{
    struct pt_settings *settings = &world->settings;
    struct decoders decoders = {{-1, -1}};
    size_t record_words = sizeof(struct pt_texture) / sizeof(float);
    if (scene->texture_count == 0) {
        return BRDF_OK;
    }
    settings->features |= PT_HAS_TEXTURES;
    brdf_status status =
        world_append(words, NULL, scene->texture_count * record_words, &settings->textures, error);
    for (size_t i = 0; i < scene->texture_count && status == BRDF_OK; ++i) {
        struct pt_texture record = scene->textures[i].record;
        settings->features |= record.kind == PT_TEXTURE_WOODGRAIN ? PT_HAS_WOODGRAINS : 0;
        if (record.kind == PT_TEXTURE_BITMAP) {
            settings->features |= PT_HAS_BITMAPS;
            settings->features |= scene->textures[i].codes ? 0 : PT_HAS_FLOAT_TEXELS;
            status = put_texels(&scene->textures[i], &record, &decoders, words, error);
        }
        if (status == BRDF_OK) {
            memcpy(words->words + settings->textures + i * record_words, &record, sizeof record);
        }
    }
    return status;
}

brdf_status world_bindings(const struct brdfcl_scene *scene, const struct brdf_bsdf *bsdf,
                           struct world_words *words, int *first, unsigned *textured,
                           unsigned *colors, struct brdf_error *error)
{
    size_t count = 0;
    const struct scene_binding *bindings = scene_bindings_of(scene, bsdf, &count);
    size_t record_words = sizeof(struct pt_binding) / sizeof(float);
    brdf_status status = BRDF_OK;
    if (count > 0) {
        status = world_append(words, NULL, count * record_words, first, error);
    }
    for (size_t i = 0; i < count && status == BRDF_OK; ++i) {
        *textured |= 1u << bindings[i].word;
        *colors |= (bindings[i].color ? 1u : 0u) << bindings[i].word;
        memcpy(words->words + (size_t)*first + i * record_words, &bindings[i].record,
               sizeof bindings[i].record);
    }
    return status;
}
