/*
 * scene_mesh_file.c - the content of obj and ply files, by assimp; polygons become fans.
 */
#define _POSIX_C_SOURCE 200809L
#include "scene_mesh.h"

#include <errno.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <assimp/cimport.h>
#include <assimp/scene.h>

#define MESH_TRIANGLES_MAX (INT_MAX / PT_ROW)

/* What the functions here share. */
struct mesh_source {
    const struct scene_loader *loader;
    const struct xml_node *node;
    const char *path;
    const struct scene_mesh_options *options;
};

void mesh_free(struct mesh *mesh)
{
    free(mesh->corners);
    memset(mesh, 0, sizeof *mesh);
}

static struct mesh_corner *mesh_append(struct mesh *mesh)
{
    if (mesh->triangle_count == mesh->triangle_capacity) {
        size_t capacity = mesh->triangle_capacity + mesh->triangle_capacity / 2 + 256;
        struct mesh_corner *corners = realloc(mesh->corners, 3 * capacity * sizeof *corners);
        if (!corners) {
            return NULL;
        }
        mesh->corners = corners;
        mesh->triangle_capacity = capacity;
    }
    return mesh->corners + 3 * mesh->triangle_count++;
}

static brdf_status mesh_fail_vertex(const struct mesh_source *source, unsigned index,
                                    const char *what)
{
    return scene_fail(source->loader, source->node, BRDF_BAD_FILE, "%s: vertex %u has %s",
                      source->path, index, what);
}

/* Position, normal and texture coordinates of a vertex, in world space. */
static brdf_status mesh_read_corner(const struct mesh_source *source, const struct aiMesh *input,
                                    unsigned index, struct mesh_corner *corner)
{
    const double *m = source->options->to_world;
    const struct aiVector3D *p = &input->mVertices[index];
    double v[3] = {(double)p->x, (double)p->y, (double)p->z};
    double w[3];
    memset(corner, 0, sizeof *corner);
    scene_matrix_point(m, v, w);
    for (int i = 0; i < 3; ++i) {
        corner->position[i] = (float)w[i];
        if (!(fabs(w[i]) <= (double)FLT_MAX)) {
            return mesh_fail_vertex(source, index, "a position that is not finite");
        }
    }
    if (input->mNormals && !source->options->face_normals) {
        const struct aiVector3D *n = &input->mNormals[index];
        double normal[3] = {(double)n->x, (double)n->y, (double)n->z};
        scene_matrix_normal(m, normal, w);
        for (int i = 0; i < 3; ++i) {
            corner->normal[i] = (float)w[i];
            if (!(fabs(normal[i]) <= (double)FLT_MAX)) {
                return mesh_fail_vertex(source, index, "a normal that is not finite");
            }
        }
    }
    if (input->mTextureCoords[0]) {
        const struct aiVector3D *uv = &input->mTextureCoords[0][index];
        corner->uv[0] = uv->x;
        corner->uv[1] = source->options->flip_uv ? 1.0f - uv->y : uv->y;
        if (!(fabsf(corner->uv[0]) <= FLT_MAX && fabsf(corner->uv[1]) <= FLT_MAX)) {
            return mesh_fail_vertex(source, index, "texture coordinates that are not finite");
        }
    }
    return BRDF_OK;
}

/* Triangles (0, k - 1, k) of one polygon. */
static brdf_status mesh_read_face(const struct mesh_source *source, const struct aiMesh *input,
                                  size_t first_vertex, const struct aiFace *face, struct mesh *mesh)
{
    for (unsigned k = 0; k < face->mNumIndices; ++k) {
        if (face->mIndices[k] >= input->mNumVertices) {
            return scene_fail(source->loader, source->node, BRDF_BAD_FILE,
                              "%s: a face refers to vertex %u of %u (counted from 0)", source->path,
                              face->mIndices[k], input->mNumVertices);
        }
    }
    mesh->thin_count += face->mNumIndices < 3;
    for (unsigned k = 2; k < face->mNumIndices; ++k) {
        unsigned indices[3] = {face->mIndices[0], face->mIndices[k - 1], face->mIndices[k]};
        struct mesh_corner *corners = mesh_append(mesh);
        float cross[3];
        if (!corners) {
            return scene_fail_memory(source->loader, source->node);
        }
        for (int i = 0; i < 3; ++i) {
            brdf_status status = mesh_read_corner(source, input, indices[i], &corners[i]);
            if (status) {
                return status;
            }
            corners[i].vertex = first_vertex + indices[i];
        }
        if (!(mesh_triangle_cross(corners, cross) > 0.0f)) {
            --mesh->triangle_count;
            ++mesh->flat_count;
        }
        if (mesh->triangle_count > MESH_TRIANGLES_MAX) {
            return scene_fail(source->loader, source->node, BRDF_UNSUPPORTED,
                              "%s: more than %d triangles", source->path, MESH_TRIANGLES_MAX);
        }
    }
    return BRDF_OK;
}

static brdf_status mesh_read_input(const struct mesh_source *source, const struct aiScene *input,
                                   struct mesh *mesh)
{
    for (unsigned i = 0; i < input->mNumMeshes; ++i) {
        const struct aiMesh *part = input->mMeshes[i];
        mesh->has_normals |= part->mNormals && !source->options->face_normals;
        mesh->has_uvs |= part->mTextureCoords[0] != NULL;
        for (unsigned f = 0; f < part->mNumFaces; ++f) {
            brdf_status status =
                mesh_read_face(source, part, mesh->vertex_count, &part->mFaces[f], mesh);
            if (status) {
                return status;
            }
        }
        mesh->vertex_count += part->mNumVertices;
    }
    if (mesh->triangle_count == 0) {
        return scene_fail(source->loader, source->node, BRDF_BAD_FILE,
                          "%s: no triangles (%lu without area, %lu points and lines)", source->path,
                          (unsigned long)mesh->flat_count, (unsigned long)mesh->thin_count);
    }
    return BRDF_OK;
}

/* The whole file: so that what is missing or unreadable is said in our words, and the reader is
   chosen by the plugin, not by the suffix. */
static brdf_status mesh_read_bytes(const struct mesh_source *source, char **bytes, size_t *length)
{
    FILE *file = fopen(source->path, "rb");
    size_t capacity = 0;
    size_t got;
    brdf_status status = BRDF_OK;
    *bytes = NULL;
    *length = 0;
    if (!file) {
        return scene_fail(source->loader, source->node, BRDF_IO, "%s: cannot be opened: %s",
                          source->path, strerror(errno));
    }
    do {
        if (*length == capacity) {
            char *more;
            capacity = 2 * capacity + 65536;
            more = realloc(*bytes, capacity);
            if (!more) {
                status = scene_fail_memory(source->loader, source->node);
                goto done;
            }
            *bytes = more;
        }
        got = fread(*bytes + *length, 1, capacity - *length, file);
        *length += got;
    } while (got > 0);
    if (ferror(file)) {
        status = scene_fail(source->loader, source->node, BRDF_IO, "%s: cannot be read: %s",
                            source->path, strerror(errno));
    } else if (*length == 0 || *length > UINT_MAX) {
        status = scene_fail(source->loader, source->node, BRDF_BAD_FILE, "%s: %s", source->path,
                            *length == 0 ? "the file is empty" : "the file is over 4 GB");
    }
done:
    fclose(file);
    return status;
}

brdf_status mesh_read(const struct scene_loader *loader, const struct xml_node *node,
                      const char *path, const struct scene_mesh_options *options, struct mesh *mesh)
{
    struct mesh_source source = {loader, node, path, options};
    const struct aiScene *input = NULL;
    char *bytes = NULL;
    size_t length = 0;
    brdf_status status = mesh_read_bytes(&source, &bytes, &length);
    memset(mesh, 0, sizeof *mesh);
    if (!status && strcmp(options->type, "ply") == 0) {
        status = mesh_check_ply(loader, node, path, bytes, length);
    }
    if (status) {
        goto done;
    }
    input = aiImportFileFromMemory(bytes, (unsigned)length, 0, options->type);
    if (!input) {
        status = scene_fail(loader, node, BRDF_BAD_FILE, "%s: not a valid %s file: %s", path,
                            options->type, aiGetErrorString());
        goto done;
    }
    status = mesh_read_input(&source, input, mesh);
done:
    if (input) {
        aiReleaseImport(input);
    }
    free(bytes);
    return status;
}
