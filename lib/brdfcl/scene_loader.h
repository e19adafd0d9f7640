/*
 * scene_loader.h - what the parts of the scene loader share while a file is being read.
 *
 * The file becomes a tree (scene_xml.h); names are substituted (scene_define.c), tags and
 * attributes are checked (scene_grammar.c), references resolved (scene_reference.c). Then each
 * plugin has its own file, which reads its parameters through a table of slots (scene_slot.c).
 */
#ifndef BRDFCL_LIB_SCENE_LOADER_H
#define BRDFCL_LIB_SCENE_LOADER_H

#include <brdf/info.h>

#include "scene.h"
#include "scene_xml.h"

struct scene_loader {
    struct brdfcl_scene *scene;
    struct xml_document document;
    struct brdf_error *error;
    struct scene_name *ids; /* sorted; scene_reference.c */
    size_t id_count;
    size_t surface_capacity;
    size_t fork_capacity;
    size_t bsdf_capacity;
    size_t texture_capacity;
    size_t binding_capacity;
};

/* --- scene_report.c: what there is to say --- */

/* Fail with "file:line:column: " and a sentence. */
#ifdef __GNUC__
__attribute__((format(printf, 4, 5)))
#endif
brdf_status
scene_fail(const struct scene_loader *loader, const struct xml_node *node, brdf_status status,
           const char *format, ...);

/* Fail since `name` is not one of the known ones; `what` says of what kind it is. */
brdf_status scene_fail_unknown(const struct scene_loader *loader, const struct xml_node *node,
                               const char *what, const char *name, const char *const *known,
                               size_t count);
brdf_status scene_fail_memory(const struct scene_loader *loader, const struct xml_node *node);

/* Put another library's error behind the place of a node. */
brdf_status scene_fail_inner(const struct scene_loader *loader, const struct xml_node *node,
                             const struct brdf_error *inner);

/* A remark, kept in the scene, with the place of the node. */
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
brdf_status
scene_note(const struct scene_loader *loader, const struct xml_node *node, const char *format, ...);

/* --- scene_define.c, scene_grammar.c, scene_reference.c: passes over the whole tree --- */

brdf_status scene_define_apply(struct scene_loader *loader, const struct brdfcl_define *defines,
                               size_t count);
brdf_status scene_grammar_check(const struct scene_loader *loader);
brdf_status scene_reference_resolve(struct scene_loader *loader);
void scene_reference_free(struct scene_loader *loader);

enum xml_class { XML_OBJECT, XML_PROPERTY, XML_OPERATION, XML_REFERENCE, XML_OTHER };

/* What kind of element it is, by its tag. */
enum xml_class scene_grammar_class(const struct xml_node *node);

/* The element itself, or the one that a <ref> stands for. */
struct xml_node *scene_reference_target(const struct scene_loader *loader, struct xml_node *node);

/* The next object among the children of a parent, <ref>s resolved, with this tag (NULL: any);
 *child is the cursor, NULL before the first. Returns NULL after the last. */
struct xml_node *scene_object_next(const struct scene_loader *loader, const struct xml_node *parent,
                                   const char *tag, struct xml_node **child);

/* --- scene_value.c: texts that are numbers, paths or one of a list --- */

/* Is `name` an item of a list such as "box|tent"? */
int scene_list_has(const char *list, const char *name);

/* The only number in a text, finite and within float's range. */
brdf_status scene_value_number(const struct scene_loader *loader, const struct xml_node *node,
                               const char *text, double *number);

/* At most `max` numbers, separated by spaces or commas. */
brdf_status scene_value_numbers(const struct scene_loader *loader, const struct xml_node *node,
                                const char *text, double *numbers, int max, int *count);

/* Three components in the attributes x, y, z, or 1 or 3 in `value`; what is not there keeps `rest`;
   where `complete`, nothing may lack. */
brdf_status scene_value_vector(const struct scene_loader *loader, const struct xml_node *node,
                               double rest, int complete, double vector[3]);

/* An <rgb>: one or three numbers, or #rrggbb in sRGB, made linear. */
brdf_status scene_value_color(const struct scene_loader *loader, const struct xml_node *node,
                              double color[3]);

/* A path that is relative to the scene file's folder, malloc'd. */
char *scene_value_path(const struct scene_loader *loader, const char *name);

/* --- scene_slot.c: the parameters of a plugin, as a table --- */

enum scene_slot_kind {
    SLOT_REAL,     /* double */
    SLOT_INTEGER,  /* int */
    SLOT_BOOLEAN,  /* int */
    SLOT_STRING,   /* const char *, lives as long as the document */
    SLOT_POINT,    /* double[3] */
    SLOT_RADIANCE, /* double[3]: <rgb>, <spectrum>, <float>; not negative */
    SLOT_COLOR,    /* double[3]: the same, but not light */
    SLOT_TRANSFORM /* double[16], row-major */
};

struct scene_slot {
    const char *name;
    enum scene_slot_kind kind;
    void *value; /* holds the default before */
    double low;  /* REAL, INTEGER: the least and the greatest value */
    double high;
    const struct xml_node *given; /* set where the file gives it */
};

/* Fill the slots from the children of a plugin's element. Unknown, double and mistyped parameters
   fail, and so do nested objects whose tag is not in `objects` (separated by "|"). */
brdf_status scene_slots_read(const struct scene_loader *loader, struct xml_node *node,
                             struct scene_slot *slots, size_t count, const char *objects);

/* Fail unless the string is one of the names. */
brdf_status scene_slot_check(const struct scene_loader *loader, const struct scene_slot *slot,
                             const char *const *names, size_t count);

/* Say, for each slot that was given, that it changes nothing here. */
brdf_status scene_slots_note(const struct scene_loader *loader, const struct scene_slot *slots,
                             size_t count);

/* --- scene_matrix.c, scene_transform.c: affine maps, double[16], row-major --- */

void scene_matrix_identity(double m[16]);
void scene_matrix_multiply(const double a[16], const double b[16], double product[16]);
void scene_matrix_point(const double m[16], const double p[3], double out[3]);
void scene_matrix_vector(const double m[16], const double v[3], double out[3]);
void scene_matrix_normal(const double m[16], const double n[3], double out[3]); /* unit */
void scene_matrix_inverse(const double m[16], double inverse[16]); /* m is not singular */
double scene_matrix_determinant(const double m[16]);               /* upper 3 x 3 */
int scene_matrix_is_singular(const double m[16]); /* has no inverse in float's precision */

/* Are the columns of the upper 3 x 3 orthogonal, and all of the same length? */
int scene_matrix_is_uniform(const double m[16], double *scale);

brdf_status scene_transform_read(const struct scene_loader *loader, const struct xml_node *node,
                                 double m[16]);

/* --- The plugins --- */

/* The bsdf of one model, made once and shared; owned by the scene. `twosided` is the element around
   it, or NULL. */
brdf_status scene_bsdf_read(struct scene_loader *loader, struct xml_node *node,
                            const struct xml_node *twosided, struct brdf_bsdf **bsdf);

/* Any bsdf, composed ones as well, as the surface or fork (struct scene_fork) that a primitive
   refers to. With radiance NULL it is only checked, and *reference stays. */
brdf_status scene_compose_read(struct scene_loader *loader, struct xml_node *node,
                               const double radiance[3], int *reference);

/*
 * The number of a texture's element (a <ref> resolved already), read once and shared. What sets a
 * parameter by it also looks at least and most of brdfcl_scene.textures[*number].
 */
brdf_status scene_texture_read(struct scene_loader *loader, struct xml_node *node, int *number);

/* The part of scene_texture_read that reads a woodgrain's element, and the names of what it can
   set. scene_woodgrain.c */
brdf_status scene_woodgrain_read(struct scene_loader *loader, struct xml_node *node,
                                 struct scene_texture *texture);

/*
 * Which output of a texture sets a parameter: the one that the file asks for, or else, of a
 * woodgrain, the one that is meant for parameters of this name. Fails where there is none.
 */
brdf_status scene_texture_output(const struct scene_loader *loader, const struct xml_node *node,
                                 int texture, const char *parameter, int *output);

/* The least and the greatest value of an output. */
void scene_texture_range(const struct scene_texture *texture, int output, float *least,
                         float *most);

#define SCENE_BINDINGS_MAX BRDF_MATERIAL_WORDS

/* The textured parameters of a bsdf that is being read, in the order of their words. */
struct scene_bindings {
    struct scene_binding list[SCENE_BINDINGS_MAX];
    size_t count;
};

/*
 * A <texture> or a <ref> to one among the children of a bsdf: note what it sets. *stand_in is a
 * setting with which the model takes the parameter as given; its value is never looked at.
 */
brdf_status scene_binding_read(struct scene_loader *loader, struct xml_node *child,
                               const struct brdf_model_info *model, struct scene_bindings *bindings,
                               struct brdf_setting *stand_in);

/* What a texture sets has a range: a picture's values are clamped to it, with a remark, and numbers
   of the file refused. */
brdf_status scene_texture_check(const struct scene_loader *loader, const struct xml_node *node,
                                const struct pt_binding *binding, const char *name);

/* Tie them to the bsdf that was made, which must not be shared with one that has others. */
brdf_status scene_bindings_keep(struct scene_loader *loader, const struct xml_node *node,
                                const struct brdf_bsdf *bsdf,
                                const struct scene_bindings *bindings);

/* Hand a new bsdf over to the scene, also if this fails; *bsdf becomes an equal one where there was
   one already. scene_bsdf_keep.c */
brdf_status scene_bsdf_keep(struct scene_loader *loader, const struct xml_node *node,
                            const struct scene_bindings *bindings, struct brdf_bsdf **bsdf);

/* Add to a model's settings what Mitsuba 3's plugin of that name assumes where the file is silent
   and our model assumes something else; the new count, at most `max`. */
size_t scene_mitsuba_assume(const char *model, struct brdf_setting *settings, size_t count,
                            size_t max);

/* What a shape without a bsdf has: gray, or black where it emits. */
brdf_status scene_bsdf_default(struct scene_loader *loader, const struct xml_node *node, int emits,
                               struct brdf_bsdf **bsdf);

/* The surface with this bsdf (NULL: light goes through), tilt (NULL: none) and radiance: equal ones
   are one. */
brdf_status scene_surface_add(struct scene_loader *loader, const struct xml_node *node,
                              struct brdf_bsdf *bsdf, const struct scene_tilt *tilt,
                              const double radiance[3], int *surface);

/* What a normalmap or a bumpmap says besides the bsdf inside. */
brdf_status scene_tilt_read(struct scene_loader *loader, struct xml_node *node,
                            struct scene_tilt *tilt);

/* The only texture among the children of an element, which must be called `name` (NULL: anything);
 *given is its element, or NULL where there is none. */
brdf_status scene_texture_child(struct scene_loader *loader, const struct xml_node *node,
                                const char *name, const struct xml_node **given, int *number);

/* The radiance of an area emitter. */
brdf_status scene_emitter_area(const struct scene_loader *loader, struct xml_node *node,
                               double radiance[3]);

/* An emitter of the scene itself: constant or envmap. */
brdf_status scene_emitter_read(struct scene_loader *loader, struct xml_node *node);

brdf_status scene_shape_read(struct scene_loader *loader, struct xml_node *node);
brdf_status scene_sensor_read(struct scene_loader *loader, struct xml_node *node);
brdf_status scene_film_read(struct scene_loader *loader, struct xml_node *node);
brdf_status scene_sampler_read(struct scene_loader *loader, struct xml_node *node);
brdf_status scene_integrator_read(struct scene_loader *loader, struct xml_node *node);

struct scene_mesh_options {
    const char *type; /* "obj" or "ply" */
    double to_world[16];
    int face_normals;
    int flip_normals;
    int flip_uv;
};

/* Append the triangles of a file; `node` is for messages. */
brdf_status scene_mesh_read(struct scene_loader *loader, const struct xml_node *node,
                            const char *path, const struct scene_mesh_options *options,
                            int surface);

/* A zeroed record at the end of the rows, NULL if there is no memory left. */
float *scene_rows_append(struct scene_rows *rows);
void scene_word_set(float *row, int word, int value); /* an int's bits */

#endif
