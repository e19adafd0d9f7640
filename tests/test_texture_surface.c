/*
 * test_texture_surface.c - texture coordinates of every shape, and what becomes of a parameter that
 * a texture sets.
 */
#include "angle.h"
#include "texture_stage.h"

#include <math.h>

#define COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* --- Texture coordinates --- */

/* What a ray from `from` through `to` meets of the only shape. */
static struct pt_interaction meet(const struct stage *stage, const double from[3],
                                  const double to[3])
{
    struct pt_ray ray;
    struct pt_distance best = {PT_MISS_T, 0.0f, 0.0f};
    int nearest = -1;
    ray.o = brdf_vec3_make((float)from[0], (float)from[1], (float)from[2]);
    ray.d =
        brdf_normalize(brdf_sub(brdf_vec3_make((float)to[0], (float)to[1], (float)to[2]), ray.o));
    for (int i = 0; i < stage->world.settings.primitive_count; ++i) {
        struct pt_primitive p = pt_load_primitive(stage->w, i);
        struct pt_distance hit =
            p.kind == PT_SPHERE ? pt_sphere_distance(ray, p.p, p.radius)
                                : pt_plane_distance(ray, pt_plane_make(p.p, p.e1, p.e2), p.kind);
        if (hit.t < best.t) {
            best = hit;
            nearest = i;
        }
    }
    assert_true(nearest >= 0);
    struct brdf_quad hit = brdf_quad_make(best.t, best.u, best.v, brdf_from_bits(nearest));
    return pt_interact(stage->w, pt_load_primitive(stage->w, nearest), ray, hit);
}

#define TEXTURED "<bsdf type='diffuse'><texture type='checkerboard' name='reflectance'/></bsdf>"

static void assert_uv(const char *name, struct pt_interaction at, double u, double v)
{
    if (!(fabs((double)at.u - u) <= 2e-6 && fabs((double)at.v - v) <= 2e-6)) {
        fail_msg("%s: (%.7g, %.7g), expected (%.7g, %.7g)", name, (double)at.u, (double)at.v, u, v);
    }
}

static void planar_coordinates(void **state)
{
    struct stage rectangle;
    struct stage disk;
    (void)state;
    stage_open(&rectangle, "<shape type='rectangle'>" TEXTURED "</shape>");
    stage_open(&disk, "<shape type='disk'>" TEXTURED "</shape>");
    for (int i = 0; i < 24; ++i) {
        double angle = 2.0 * pi * (i + 0.3) / 24.0;
        double to[3] = {0.7 * cos(angle), 0.7 * sin(angle), 0.0};
        const double from[3] = {0.1, -0.2, 3.0};
        assert_uv("rectangle", meet(&rectangle, from, to), 0.5 + 0.5 * to[0], 0.5 + 0.5 * to[1]);
        assert_uv("disk", meet(&disk, from, to), 0.7, angle / (2.0 * pi));
    }
    stage_close(&rectangle);
    stage_close(&disk);
}

/* From the +x axis around +z, and down from +z; so it is inside out, and mirrored with the shape.
 */
static void spherical_coordinates(void **state)
{
    static const char *const shapes[] = {
        "<shape type='sphere'>" TEXTURED "</shape>",
        "<shape type='sphere'><boolean name='flip_normals' value='true'/>" TEXTURED "</shape>",
        "<shape type='sphere'><transform name='to_world'><scale x='1' y='1' z='-1'/></transform>"
        "<boolean name='flip_normals' value='true'/>" TEXTURED "</shape>",
        "<shape type='sphere'><transform name='to_world'><scale x='1' y='1' z='-1'/>"
        "</transform>" TEXTURED "</shape>"};
    (void)state;
    for (size_t k = 0; k < COUNT(shapes); ++k) {
        struct stage stage;
        stage_open(&stage, shapes[k]);
        for (int i = 0; i < 200; ++i) {
            double turns = (i % 20 + 0.3) / 20.0;
            double polar = (i / 20 + 0.4) / 10.0;
            double side = k < 2 ? 1.0 : -1.0;
            double out[3] = {cos(2.0 * pi * turns) * sin(pi * polar),
                             sin(2.0 * pi * turns) * sin(pi * polar), side * cos(pi * polar)};
            double from[3] = {2.0 * out[0], 2.0 * out[1], 2.0 * out[2]};
            assert_uv(shapes[k], meet(&stage, from, out), turns, polar);
        }
        stage_close(&stage);
    }
}

/* With coordinates in the file those; without, barycentric ones, smooth or flat. */
static void mesh_coordinates(void **state)
{
    static const char *const files[] = {"v 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0.5 0.25\nvt 1.5 0.5\n"
                                        "vt 0.25 2\nf 1/1 2/2 3/3\n",
                                        "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"};
    (void)state;
    for (int k = 0; k < 4; ++k) {
        char content[512];
        struct stage stage;
        const double from[3] = {0.5, 0.75, 4.0};
        const double to[3] = {0.5, 0.75, 0.0};
        scene_file_write("mesh.obj", files[k / 2]);
        snprintf(content, sizeof content,
                 "<shape type='obj'><string name='filename' value='mesh.obj'/>"
                 "<boolean name='flip_tex_coords' value='false'/>"
                 "<boolean name='face_normals' value='%s'/>" TEXTURED "</shape>",
                 k % 2 ? "true" : "false");
        stage_open(&stage, content);
        if (k < 2) {
            assert_uv("mesh", meet(&stage, from, to), 0.5 + 0.25 * 1.0 - 0.375 * 0.25,
                      0.25 + 0.25 * 0.25 + 0.375 * 1.75);
        } else {
            assert_uv("bare mesh", meet(&stage, from, to), 0.25, 0.375);
        }
        stage_close(&stage);
    }
}

/* --- Parameters --- */

static brdf_parameters parameters_at(const struct stage *stage, double u, double v)
{
    struct pt_interaction at;
    const struct world_variant *variant = &stage->world.variants[0];
    const struct pt_surface *surface = pt_surface_at(stage->w, 0);
    memset(&at, 0, sizeof at);
    at.u = (float)u;
    at.v = (float)v;
    return pt_textured_parameters(
        stage->w, variant->model, variant->textured, variant->colors, surface->bindings, at,
        brdf_parameters_load(variant->model, variant->choices, surface->material.word));
}

#define BOARD(name, color0, color1)                                                                \
    "<texture type='checkerboard' name='" name "'><rgb name='color0' value='" color0 "'/>"         \
    "<rgb name='color1' value='" color1 "'/></texture>"
#define SPHERE(bsdf) "<shape type='sphere'>" bsdf "</shape>"

static void parameters(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage,
               SPHERE("<bsdf type='roughconductor'>" BOARD("alpha", "0.1, 0.2, 0.3", "0.5")
                          BOARD("specular_reflectance", "0.25", "0.9, 0.5, 0.1") "</bsdf>"));
    for (int k = 0; k < 2; ++k) {
        static const double colors[2][3] = {{0.25, 0.25, 0.25}, {0.9, 0.5, 0.1}};
        double u = k == 0 ? 0.2 : 0.7;
        double alpha = k == 0 ? 0.2126 * 0.1 + 0.7152 * 0.2 + 0.0722 * 0.3 : 0.5;
        const struct brdf_material *material = &pt_surface_at(stage.w, 0)->material;
        struct brdf_roughconductor plain =
            brdf_parameters_load(material->model, material->choices, material->word).roughconductor;
        struct brdf_roughconductor p = parameters_at(&stage, u, 0.3).roughconductor;
        assert_float_equal(p.alpha_u, (float)alpha, 1e-6f); /* a colour counts by its luminance */
        assert_true(p.alpha_u == p.alpha_v);                /* an alias sets both */
        assert_color("specular_reflectance", u, 0.3, p.specular_reflectance, colors[k]);
        assert_true(p.k.r == plain.k.r && p.eta.b == plain.eta.b);
    }
    stage_close(&stage);
}

/* A picture may hold more than a parameter takes: it is clamped, and that is said. */
static void clamped_parameters(void **state)
{
    struct brdfcl_image image;
    struct brdf_error error;
    struct stage stage;
    (void)state;
    assert_int_equal(brdfcl_image_create(&image, 2, 1, &error), BRDF_OK);
    for (int c = 0; c < 3; ++c) {
        image.rgb[c] = -1.0f;
        image.rgb[3 + c] = 7.0f;
    }
    assert_int_equal(brdfcl_image_write(&image, scene_file_write("wild.exr", ""), NULL, &error),
                     BRDF_OK);
    brdfcl_image_destroy(&image);
    stage_open(&stage, SPHERE("<bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
                              "<string name='filename' value='wild.exr'/></texture></bsdf>"));
    assert_true(scene_has_note(stage.scene, "reflectance: the texture's values, -1 to 7, are "
                                            "clamped to its range, 0 to 1"));
    assert_true(parameters_at(&stage, 0.25, 0.5).diffuse.reflectance.r == 0.0f);
    assert_true(parameters_at(&stage, 0.75, 0.5).diffuse.reflectance.g == 1.0f);
    stage_close(&stage);
}

/* Kernels are shared by surfaces that differ in their textures only, and by no others. */
static void variants(void **state)
{
    struct stage stage;
    (void)state;
    stage_open(&stage,
               SPHERE("<bsdf type='diffuse'>" BOARD("reflectance", "0.1", "0.2") "</bsdf>")
                   SPHERE("<bsdf type='diffuse'>" BOARD("reflectance", "0.3", "0.4") "</bsdf>")
                       SPHERE("<bsdf type='diffuse'/>"));
    assert_int_equal(stage.world.settings.variant_count, 3); /* with that of what is missed */
    assert_int_equal(stage.scene->surface_count, 3);
    assert_int_equal(stage.scene->texture_count, 2);
    assert_int_equal(stage.world.variants[0].textured, 1);
    assert_int_equal(stage.world.variants[0].colors, 1);
    assert_int_equal(stage.world.variants[1].textured, 0);
    stage_close(&stage);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(planar_coordinates), cmocka_unit_test(spherical_coordinates),
        cmocka_unit_test(mesh_coordinates),   cmocka_unit_test(parameters),
        cmocka_unit_test(clamped_parameters), cmocka_unit_test(variants),
    };
    return cmocka_run_group_tests(tests, scene_files_open, scene_files_close);
}
