/*
 * scene_mesh.h - a mesh on its way from a file to the rows of triangles.
 */
#ifndef BRDFCL_LIB_SCENE_MESH_H
#define BRDFCL_LIB_SCENE_MESH_H

#include "scene_loader.h"

/* One corner of a triangle, in world space. */
struct mesh_corner {
    float position[3];
    float normal[3]; /* unit; 0 where there is none */
    float uv[2];
    size_t vertex; /* corners of the same vertex share their computed normal */
};

struct mesh {
    struct mesh_corner *corners; /* three a triangle */
    size_t triangle_count;
    size_t triangle_capacity;
    size_t vertex_count;
    size_t flat_count; /* triangles without area, dropped */
    size_t thin_count; /* points and lines, dropped */
    int has_normals;   /* somewhere in the file */
    int has_uvs;
};

/* Read a file as obj or ply; the mesh is to be freed with mesh_free in any case. */
brdf_status mesh_read(const struct scene_loader *loader, const struct xml_node *node,
                      const char *path, const struct scene_mesh_options *options,
                      struct mesh *mesh);
void mesh_free(struct mesh *mesh);

/* Fail unless the bytes of a ply file have a complete header, and as much behind it as it says. */
brdf_status mesh_check_ply(const struct scene_loader *loader, const struct xml_node *node,
                           const char *path, const char *bytes, size_t length);

/* Number the vertices of corners anew: those at the same place with the same texture coordinates
   are one. 0 if there is no memory left. */
int mesh_join(struct mesh *mesh);

/* Give every corner the mean normal of its vertex's triangles. 0 if there is no memory left. */
int mesh_compute_normals(struct mesh *mesh);

/* e1 x e2 of a triangle; returns its squared length, 0 where it is too small to be normalised. */
float mesh_triangle_cross(const struct mesh_corner *corners, float cross[3]);

#endif
