/*
 * scene_mesh_normals.c - smooth normals for meshes that come without.
 */
#include "scene_mesh.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

float mesh_triangle_cross(const struct mesh_corner *corners, float cross[3])
{
    float a[3];
    float b[3];
    float length2;
    for (int i = 0; i < 3; ++i) {
        a[i] = corners[1].position[i] - corners[0].position[i];
        b[i] = corners[2].position[i] - corners[0].position[i];
    }
    cross[0] = a[1] * b[2] - a[2] * b[1];
    cross[1] = a[2] * b[0] - a[0] * b[2];
    cross[2] = a[0] * b[1] - a[1] * b[0];
    length2 = cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2];
    return length2 >= FLT_MIN && length2 <= FLT_MAX ? length2 : 0.0f;
}

/* Position and texture coordinates; -0 is 0. */
static void mesh_key(const struct mesh_corner *corner, float key[5])
{
    for (int i = 0; i < 3; ++i) {
        key[i] = corner->position[i] + 0.0f;
    }
    key[3] = corner->uv[0] + 0.0f;
    key[4] = corner->uv[1] + 0.0f;
}

/* FNV-1a over the words. */
static size_t mesh_hash(const float key[5])
{
    uint64_t hash = 14695981039346656037u;
    for (int i = 0; i < 5; ++i) {
        uint32_t word;
        memcpy(&word, &key[i], sizeof word);
        hash = (hash ^ word) * 1099511628211u;
    }
    return (size_t)(hash ^ hash >> 32);
}

int mesh_join(struct mesh *mesh)
{
    size_t corner_count = 3 * mesh->triangle_count;
    size_t size = 16;
    size_t *table; /* open addressing: a corner's number + 1, 0 = free */
    mesh->vertex_count = 0;
    while (size < 2 * corner_count) {
        size *= 2;
    }
    table = calloc(size, sizeof *table);
    if (!table) {
        return 0;
    }
    for (size_t c = 0; c < corner_count; ++c) {
        float key[5];
        float other[5];
        size_t slot;
        mesh_key(&mesh->corners[c], key);
        for (slot = mesh_hash(key) & (size - 1); table[slot]; slot = (slot + 1) & (size - 1)) {
            mesh_key(&mesh->corners[table[slot] - 1], other);
            if (memcmp(key, other, sizeof key) == 0) {
                break;
            }
        }
        if (!table[slot]) {
            table[slot] = c + 1;
            mesh->corners[c].vertex = mesh->vertex_count++;
        } else {
            mesh->corners[c].vertex = mesh->corners[table[slot] - 1].vertex;
        }
    }
    free(table);
    return 1;
}

/* The angle of a triangle at corner i. */
static double mesh_angle(const struct mesh_corner *corners, int i)
{
    double dot = 0.0;
    double a2 = 0.0;
    double b2 = 0.0;
    double c;
    for (int k = 0; k < 3; ++k) {
        double p = (double)corners[i].position[k];
        double a = (double)corners[(i + 1) % 3].position[k] - p;
        double b = (double)corners[(i + 2) % 3].position[k] - p;
        dot += a * b;
        a2 += a * a;
        b2 += b * b;
    }
    c = dot / sqrt(a2 * b2);
    return acos(c < -1.0 ? -1.0 : c > 1.0 ? 1.0 : c);
}

/* Weighted by the angle at the vertex: Thuermer and Wuethrich, Computing Vertex Normals from
   Polygonal Facets (1998). */
int mesh_compute_normals(struct mesh *mesh)
{
    double *sums = calloc(3 * mesh->vertex_count + 1, sizeof *sums);
    if (!sums) {
        return 0;
    }
    for (size_t t = 0; t < mesh->triangle_count; ++t) {
        struct mesh_corner *corners = mesh->corners + 3 * t;
        float cross[3];
        double length = sqrt((double)mesh_triangle_cross(corners, cross));
        for (int i = 0; i < 3; ++i) {
            double weight = mesh_angle(corners, i) / length;
            for (int k = 0; k < 3; ++k) {
                sums[3 * corners[i].vertex + (size_t)k] += weight * (double)cross[k];
            }
        }
    }
    for (size_t c = 0; c < 3 * mesh->triangle_count; ++c) {
        struct mesh_corner *corner = &mesh->corners[c];
        const double *sum = sums + 3 * corner->vertex;
        double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
        for (int k = 0; k < 3; ++k) {
            corner->normal[k] = length > 0.0 ? (float)(sum[k] / length) : 0.0f;
        }
    }
    free(sums);
    return 1;
}
