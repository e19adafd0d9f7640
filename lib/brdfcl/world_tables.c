/*
 * world_tables.c - the tables of measured materials as one array, each of them once.
 *
 * Materials that differ in a parameter but name the same file have tables of the same bits; they
 * share one. Where only one is left, the array is that table itself, and nothing is copied.
 */
#include <stdlib.h>
#include <string.h>

#include "world.h"

/* The tables of a scene's bsdfs: NULL where there is none or an earlier bsdf has the same. */
struct tables {
    const float **first;
    size_t count; /* that are not NULL */
    size_t total; /* words of all, each beginning on 64 bytes */
};

/* An earlier bsdf whose table has the same bits; `number` itself if there is none. */
static size_t same_table(const struct brdfcl_scene *scene, size_t number)
{
    size_t words = 0, other_words = 0;
    const float *table = brdf_bsdf_table(scene->bsdfs[number], &words);
    for (size_t i = 0; i < number; ++i) {
        const float *other = brdf_bsdf_table(scene->bsdfs[i], &other_words);
        if (other && other_words == words && memcmp(table, other, words * sizeof *table) == 0) {
            return i;
        }
    }
    return number;
}

/* Where each table begins in the array. */
static void tables_place(const struct brdfcl_scene *scene, struct world *world,
                         struct tables *tables, unsigned *table_of_bsdf)
{
    for (size_t i = 0; i < scene->bsdf_count; ++i) {
        size_t words = 0;
        const float *table = brdf_bsdf_table(scene->bsdfs[i], &words);
        size_t same = table ? same_table(scene, i) : i;
        table_of_bsdf[i] = same < i ? table_of_bsdf[same] : (unsigned)tables->total;
        if (table && same == i) {
            tables->first[i] = table;
            tables->total += (words + 15) / 16 * 16;
            ++tables->count;
            world->tables = table;
            world->table_words = words;
        }
    }
}

static brdf_status tables_copy(const struct brdfcl_scene *scene, struct world *world,
                               const struct tables *tables, const unsigned *table_of_bsdf,
                               struct brdf_error *error)
{
    world->own_tables = world_allocate(tables->total * sizeof(float));
    if (!world->own_tables) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory for %zu measured BRDFs (%zu MB)",
                         tables->count, tables->total >> 18);
    }
    for (size_t i = 0; i < scene->bsdf_count; ++i) {
        if (tables->first[i]) {
            size_t words = 0;
            brdf_bsdf_table(scene->bsdfs[i], &words);
            memcpy(world->own_tables + table_of_bsdf[i], tables->first[i], words * sizeof(float));
        }
    }
    world->tables = world->own_tables;
    world->table_words = tables->total;
    return BRDF_OK;
}

brdf_status world_tables(const struct brdfcl_scene *scene, struct world *world,
                         unsigned *table_of_bsdf, struct brdf_error *error)
{
    brdf_status status = BRDF_OK;
    struct tables tables = {calloc(scene->bsdf_count + 1, sizeof(float *)), 0, 0};
    if (!tables.first) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "out of memory");
    }
    tables_place(scene, world, &tables, table_of_bsdf);
    if (tables.total > 0x7fffffffu) {
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY,
                           "%zu measured BRDFs need %zu MB, more than 8 GB; use fewer",
                           tables.count, tables.total >> 18);
    } else if (tables.count > 1) {
        status = tables_copy(scene, world, &tables, table_of_bsdf, error);
    }
    free(tables.first);
    return status;
}
