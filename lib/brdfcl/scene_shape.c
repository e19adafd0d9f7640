/*
 * scene_shape.c - <shape>: sphere, rectangle, cube, disk as rows of kernels/scene.h; obj and ply.
 *
 * Normals are as in Mitsuba 3: those of rectangle, disk and cube go with the inverse transposed of
 * to_world, so a mirror keeps their side; a sphere turns inside out. PT_FLIP makes e1 x e2 agree.
 */
#include "scene_loader.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* What every shape has. */
struct shape_draft {
    const struct xml_node *node;
    double to_world[16];
    int flip_normals;
    int face_normals; /* of meshes; cube and rectangle are flat, it changes nothing there */
    int surface;
};

static brdf_status shape_row(struct scene_loader *loader, const struct shape_draft *shape, int kind,
                             float **row)
{
    *row = scene_rows_append(&loader->scene->primitives);
    if (!*row) {
        return scene_fail_memory(loader, shape->node);
    }
    scene_word_set(*row, PT_KIND, kind);
    scene_word_set(*row, PT_SURFACE, shape->surface);
    scene_word_set(*row, PT_SHADING, -1);
    return BRDF_OK;
}

static void shape_put(float *row, int word, const double v[3])
{
    for (int i = 0; i < 3; ++i) {
        row[word + i] = (float)v[i];
    }
}

/* A planar row from local p, e1, e2; `outward` tells whether e1 x e2 is the local normal. */
static brdf_status shape_planar(struct scene_loader *loader, const struct shape_draft *shape,
                                int kind, const double p[3], const double e1[3], const double e2[3],
                                int outward)
{
    float *row = NULL;
    double v[3];
    brdf_status status = shape_row(loader, shape, kind, &row);
    int flip = (scene_matrix_determinant(shape->to_world) < 0.0) ^ !outward ^ shape->flip_normals;
    if (status) {
        return status;
    }
    scene_matrix_point(shape->to_world, p, v);
    shape_put(row, PT_P, v);
    scene_matrix_vector(shape->to_world, e1, v);
    shape_put(row, PT_E1, v);
    scene_matrix_vector(shape->to_world, e2, v);
    shape_put(row, PT_E2, v);
    row[PT_FLIP] = flip ? -1.0f : 1.0f;
    return BRDF_OK;
}

static brdf_status shape_rectangle(struct scene_loader *loader, const struct shape_draft *shape)
{
    static const double corner[3] = {-1.0, -1.0, 0.0};
    static const double e1[3] = {2.0, 0.0, 0.0};
    static const double e2[3] = {0.0, 2.0, 0.0};
    return shape_planar(loader, shape, PT_RECTANGLE, corner, e1, e2, 1);
}

static brdf_status shape_disk(struct scene_loader *loader, const struct shape_draft *shape)
{
    static const double centre[3] = {0.0, 0.0, 0.0};
    static const double e1[3] = {1.0, 0.0, 0.0};
    static const double e2[3] = {0.0, 1.0, 0.0};
    return shape_planar(loader, shape, PT_DISK, centre, e1, e2, 1);
}

/* Six rectangles; e1 and e2 follow Mitsuba's texture coordinates, on which anisotropy depends, and
   so e1 x e2 looks inwards. */
static brdf_status shape_cube(struct scene_loader *loader, const struct shape_draft *shape)
{
    static const double faces[6][3][3] = {
        {{1, -1, 1}, {0, 2, 0}, {0, 0, -2}},  /* +x */
        {{-1, -1, -1}, {0, 2, 0}, {0, 0, 2}}, /* -x */
        {{1, 1, 1}, {-2, 0, 0}, {0, 0, -2}},  /* +y */
        {{-1, -1, -1}, {0, 0, 2}, {2, 0, 0}}, /* -y */
        {{-1, -1, 1}, {0, 2, 0}, {2, 0, 0}},  /* +z */
        {{-1, 1, -1}, {0, -2, 0}, {2, 0, 0}}, /* -z */
    };
    brdf_status status = BRDF_OK;
    for (size_t i = 0; i < COUNT(faces) && !status; ++i) {
        status =
            shape_planar(loader, shape, PT_RECTANGLE, faces[i][0], faces[i][1], faces[i][2], 0);
    }
    return status;
}

static brdf_status shape_sphere(struct scene_loader *loader, const struct shape_draft *shape,
                                const double center[3], double radius)
{
    static const double axes[2][3] = {{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const double *m = shape->to_world;
    double scale = 0.0;
    double v[3];
    float *row = NULL;
    brdf_status status;
    if (!scene_matrix_is_uniform(m, &scale)) {
        return scene_fail(loader, shape->node, BRDF_UNSUPPORTED,
                          "a sphere can only be scaled by the same factor in every direction");
    }
    status = shape_row(loader, shape, PT_SPHERE, &row);
    if (status) {
        return status;
    }
    scene_matrix_point(m, center, v);
    shape_put(row, PT_P, v);
    for (int axis = 0; axis < 2; ++axis) {
        scene_matrix_vector(m, axes[axis], v);
        for (int i = 0; i < 3; ++i) {
            v[i] *= radius;
        }
        shape_put(row, axis == 0 ? PT_E1 : PT_E2, v);
    }
    row[PT_RADIUS] = (float)(scale * radius);
    row[PT_MIRRORED] = scene_matrix_determinant(m) < 0.0 ? 1.0f : 0.0f;
    row[PT_FLIP] = (row[PT_MIRRORED] > 0.0f) ^ shape->flip_normals ? -1.0f : 1.0f;
    if (!(row[PT_RADIUS] > 0.0f && row[PT_RADIUS] <= FLT_MAX)) {
        return scene_fail(loader, shape->node, BRDF_OUT_OF_RANGE, "the radius becomes %g",
                          scale * radius);
    }
    return BRDF_OK;
}

/* The surface of a shape: its bsdf and its area emitter, at most one each. */
static brdf_status shape_surface(struct scene_loader *loader, struct xml_node *node, int *surface)
{
    struct xml_node *child = NULL;
    struct xml_node *bsdf_node = scene_object_next(loader, node, "bsdf", &child);
    struct xml_node *emitter_node;
    struct brdf_bsdf *bsdf = NULL;
    double radiance[3] = {0.0, 0.0, 0.0};
    brdf_status status = BRDF_OK;
    if (bsdf_node && scene_object_next(loader, node, "bsdf", &child)) {
        return scene_fail(loader, child, BRDF_BAD_FILE, "a shape has only one bsdf");
    }
    child = NULL;
    emitter_node = scene_object_next(loader, node, "emitter", &child);
    if (emitter_node && scene_object_next(loader, node, "emitter", &child)) {
        return scene_fail(loader, child, BRDF_BAD_FILE, "a shape has only one emitter");
    }
    if (emitter_node) {
        status = scene_emitter_area(loader, emitter_node, radiance);
    }
    if (!status && bsdf_node) {
        return scene_compose_read(loader, bsdf_node, radiance, surface);
    }
    if (!status) {
        status = scene_bsdf_default(loader, node, emitter_node != NULL, &bsdf);
    }
    return status ? status : scene_surface_add(loader, node, bsdf, NULL, radiance, surface);
}

static brdf_status shape_mesh(struct scene_loader *loader, const struct shape_draft *shape,
                              const struct scene_slot *filename, int flip_uv)
{
    struct scene_mesh_options options;
    char *path;
    brdf_status status;
    if (!filename->given) {
        return scene_fail(loader, shape->node, BRDF_BAD_FILE, "a mesh needs a filename");
    }
    path = scene_value_path(loader, *(const char **)filename->value);
    if (!path) {
        return scene_fail_memory(loader, shape->node);
    }
    options.type = xml_attribute_get(shape->node, "type");
    memcpy(options.to_world, shape->to_world, sizeof options.to_world);
    options.face_normals = shape->face_normals;
    options.flip_normals = shape->flip_normals;
    options.flip_uv = flip_uv;
    status = scene_mesh_read(loader, filename->given, path, &options, shape->surface);
    free(path);
    return status;
}

/* Which of the slots in scene_shape_read a type has, and who makes its rows. */
static const struct shape_type {
    const char *name;
    size_t first;
    size_t count;
} shape_types[] = {{"sphere", 0, 4}, {"disk", 2, 2}, {"rectangle", 2, 3},
                   {"cube", 2, 3},   {"obj", 2, 5},  {"ply", 2, 5}};

static const struct shape_type *shape_find(const struct scene_loader *loader,
                                           const struct xml_node *node)
{
    const char *type = xml_attribute_get(node, "type");
    const char *known[COUNT(shape_types)];
    for (size_t i = 0; i < COUNT(shape_types); ++i) {
        known[i] = shape_types[i].name;
        if (strcmp(known[i], type) == 0) {
            return &shape_types[i];
        }
    }
    scene_fail_unknown(loader, node, "shape", type, known, COUNT(shape_types));
    return NULL;
}

brdf_status scene_shape_read(struct scene_loader *loader, struct xml_node *node)
{
    const struct shape_type *type = shape_find(loader, node);
    const char *name = xml_attribute_get(node, "type");
    struct shape_draft shape = {node, {0.0}, 0, 0, 0};
    const char *filename = NULL;
    double center[3] = {0.0, 0.0, 0.0};
    double radius = 1.0;
    int flip_uv = strcmp(name, "obj") == 0; /* Mitsuba's defaults: obj yes, ply no */
    struct scene_slot slots[] = {
        {"center", SLOT_POINT, center, 0.0, 0.0, NULL},
        {"radius", SLOT_REAL, &radius, (double)FLT_MIN, (double)FLT_MAX, NULL},
        {"to_world", SLOT_TRANSFORM, shape.to_world, 0.0, 0.0, NULL},
        {"flip_normals", SLOT_BOOLEAN, &shape.flip_normals, 0.0, 0.0, NULL},
        {"face_normals", SLOT_BOOLEAN, &shape.face_normals, 0.0, 0.0, NULL},
        {"filename", SLOT_STRING, &filename, 0.0, 0.0, NULL},
        {"flip_tex_coords", SLOT_BOOLEAN, &flip_uv, 0.0, 0.0, NULL},
    };
    brdf_status status;
    if (!type) {
        return BRDF_UNKNOWN_NAME;
    }
    scene_matrix_identity(shape.to_world);
    status = scene_slots_read(loader, node, slots + type->first, type->count, "bsdf|emitter");
    if (!status && scene_matrix_is_singular(shape.to_world)) {
        status = scene_fail(loader, slots[2].given, BRDF_OUT_OF_RANGE,
                            "to_world flattens the shape: it has no inverse");
    }
    if (!status) {
        status = shape_surface(loader, node, &shape.surface);
    }
    if (status) {
        return status;
    }
    if (strcmp(name, "sphere") == 0) {
        return shape_sphere(loader, &shape, center, radius);
    }
    if (strcmp(name, "disk") == 0) {
        return shape_disk(loader, &shape);
    }
    if (strcmp(name, "rectangle") == 0) {
        return shape_rectangle(loader, &shape);
    }
    if (strcmp(name, "cube") == 0) {
        return shape_cube(loader, &shape);
    }
    return shape_mesh(loader, &shape, &slots[5], flip_uv);
}
