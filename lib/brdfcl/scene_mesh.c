/*
 * scene_mesh.c - the triangles of a mesh as rows of kernels/scene.h.
 */
#include "scene_mesh.h"

#include <math.h>
#include <string.h>

/* Normals of the corners, turned where the file asks for it; the triangle's own where one is
   missing. Returns how many were. */
static int mesh_fill_normals(const struct mesh_corner *corners, int flip_normals,
                             float normals[3][3])
{
    float face[3];
    float length = sqrtf(mesh_triangle_cross(corners, face));
    int missing = 0;
    for (int i = 0; i < 3; ++i) {
        const float *n = corners[i].normal;
        int has = n[0] != 0.0f || n[1] != 0.0f || n[2] != 0.0f;
        missing += !has;
        for (int k = 0; k < 3; ++k) {
            float x = has ? n[k] : face[k] / length;
            normals[i][k] = flip_normals ? -x : x;
        }
    }
    return missing;
}

/* Which side e1 x e2 looks to is a matter of winding; the normals say which side is outside. */
static float mesh_flip(const struct mesh_corner *corners, float normals[3][3])
{
    float cross[3];
    float dot = 0.0f;
    mesh_triangle_cross(corners, cross);
    for (int k = 0; k < 3; ++k) {
        dot += cross[k] * (normals[0][k] + normals[1][k] + normals[2][k]);
    }
    return dot < 0.0f ? -1.0f : 1.0f;
}

/* Without texture coordinates, those of the triangle itself: (0, 0), (1, 0), (0, 1). */
static void mesh_fill_uvs(const struct mesh *mesh, const struct mesh_corner *corners, float *uvs)
{
    for (int i = 0; i < 3; ++i) {
        uvs[2 * i] = mesh->has_uvs ? corners[i].uv[0] : (float)(i == 1);
        uvs[2 * i + 1] = mesh->has_uvs ? corners[i].uv[1] : (float)(i == 2);
    }
}

static int mesh_put_triangle(struct brdfcl_scene *scene, const struct mesh *mesh,
                             const struct mesh_corner *corners,
                             const struct scene_mesh_options *options, int surface, size_t *missing)
{
    float normals[3][3];
    float *row = scene_rows_append(&scene->primitives);
    int bare = mesh_fill_normals(corners, options->flip_normals, normals);
    int shading = -1;
    if (!row) {
        return 0;
    }
    if (!options->face_normals || mesh->has_uvs) {
        float *smooth = scene_rows_append(&scene->shading);
        if (!smooth) {
            return 0;
        }
        shading = (int)scene->shading.count - 1;
        memcpy(smooth + PT_NORMALS, normals, sizeof normals);
        mesh_fill_uvs(mesh, corners, smooth + PT_UVS);
        *missing += options->face_normals ? 0 : (size_t)bare;
    }
    for (int k = 0; k < 3; ++k) {
        row[PT_P + k] = corners[0].position[k];
        row[PT_E1 + k] = corners[1].position[k] - corners[0].position[k];
        row[PT_E2 + k] = corners[2].position[k] - corners[0].position[k];
    }
    scene_word_set(row, PT_KIND, PT_TRIANGLE);
    scene_word_set(row, PT_SURFACE, surface);
    scene_word_set(row, PT_SHADING, shading);
    row[PT_FLIP] = mesh_flip(corners, normals);
    return 1;
}

static brdf_status mesh_note(const struct scene_loader *loader, const struct xml_node *node,
                             const char *path, const struct mesh *mesh, size_t missing)
{
    brdf_status status = BRDF_OK;
    if (mesh->flat_count > 0) {
        status = scene_note(loader, node, "%s: %lu of %lu triangles have no area and are left out",
                            path, (unsigned long)mesh->flat_count,
                            (unsigned long)(mesh->flat_count + mesh->triangle_count));
    }
    if (!status && mesh->thin_count > 0) {
        status = scene_note(loader, node, "%s: %lu points and lines are left out", path,
                            (unsigned long)mesh->thin_count);
    }
    if (!status && missing > 0) {
        status = scene_note(loader, node, "%s: %lu corners have no normal and get their triangle's",
                            path, (unsigned long)missing);
    }
    return status;
}

brdf_status scene_mesh_read(struct scene_loader *loader, const struct xml_node *node,
                            const char *path, const struct scene_mesh_options *options, int surface)
{
    struct mesh mesh;
    size_t missing = 0;
    int fits = 1;
    brdf_status status = mesh_read(loader, node, path, options, &mesh);
    if (status) {
        goto done;
    }
    if (!options->face_normals && !mesh.has_normals) {
        /* assimp gives the corners of obj faces a vertex each; ply keeps the file's vertices. */
        fits = strcmp(options->type, "obj") != 0 || mesh_join(&mesh);
        fits = fits && mesh_compute_normals(&mesh);
    }
    for (size_t t = 0; t < mesh.triangle_count && fits; ++t) {
        fits = mesh_put_triangle(loader->scene, &mesh, mesh.corners + 3 * t, options, surface,
                                 &missing);
    }
    status = fits ? mesh_note(loader, node, path, &mesh, missing) : scene_fail_memory(loader, node);
done:
    mesh_free(&mesh);
    return status;
}
