/* render_contents.c - the two scenes. */
#include "render_contents.h"

#include "angle.h"
#include "scene_files.h"

#include <math.h>

const char *const box_contents =
    "<emitter type='constant'><rgb name='radiance' value='0.1, 0.12, 0.2'/></emitter>\n"
    "<bsdf type='diffuse' id='gray'><texture type='checkerboard' name='reflectance'>"
    "<rgb name='color0' value='0.7, 0.6, 0.5'/><transform name='to_uv'><scale value='4.7'/>"
    "</transform></texture></bsdf>\n"
    "<bsdf type='diffuse' id='green'><texture type='woodgrain' name='reflectance'>"
    "<rgb name='early_color' value='0.3, 0.6, 0.4'/></texture></bsdf>\n"
    "<bsdf type='twosided' id='brushed'><bsdf type='roughconductor'>\n"
    "<string name='distribution' value='ggx'/><string name='material' value='Cu'/>\n"
    "<texture type='bitmap' name='alpha_u'><string name='filename' value='spots.png'/>"
    "<string name='wrap_mode' value='mirror'/><transform name='to_uv'><scale value='3'/>"
    "</transform></texture><float name='alpha_v' value='0.4'/></bsdf></bsdf>\n"
    "<bsdf type='dielectric' id='glass'/>\n"
    "<shape type='rectangle'><transform name='to_world'><scale value='2'/>\n"
    "<rotate x='1' angle='-90'/></transform><ref id='gray'/></shape>\n"
    "<shape type='rectangle'><transform name='to_world'><scale value='2'/>\n"
    "<translate z='-2'/></transform><ref id='green'/></shape>\n"
    "<shape type='rectangle'><transform name='to_world'><rotate y='1' angle='80'/>\n"
    "<translate x='1.9' y='1'/></transform><ref id='brushed'/></shape>\n"
    "<shape type='disk'><transform name='to_world'><scale x='0.5' y='0.8'/>\n"
    "<rotate x='1' angle='-60'/><translate x='-1' y='0.9' z='-0.5'/></transform>\n"
    "<ref id='brushed'/></shape>\n"
    "<shape type='cube'><transform name='to_world'><scale value='0.25'/><rotate y='1' "
    "angle='30'/>\n"
    "<translate x='0.9' y='0.26' z='0.9'/></transform><ref id='green'/></shape>\n"
    "<shape type='sphere'><point name='center' x='-0.5' y='0.5' z='0'/>\n"
    "<float name='radius' value='0.5'/><ref id='brushed'/></shape>\n"
    "<shape type='sphere'><point name='center' x='0.5' y='0.4' z='0.3'/>\n"
    "<float name='radius' value='0.4'/><ref id='glass'/></shape>\n"
    "<shape type='sphere'><point name='center' x='0.5' y='0.4' z='0.3'/>\n"
    "<float name='radius' value='0.1'/>\n"
    "<emitter type='area'><rgb name='radiance' value='3, 2, 1'/></emitter></shape>\n"
    "<shape type='rectangle'><transform name='to_world'><scale value='0.4'/>\n"
    "<rotate x='1' angle='90'/><translate y='2.5'/></transform>\n"
    "<emitter type='area'><rgb name='radiance' value='9, 8, 7'/></emitter></shape>\n"
    "<shape type='disk'><transform name='to_world'><scale value='0.3'/><rotate y='1' angle='90'/>\n"
    "<translate x='-1.9' y='1.5'/></transform><ref id='gray'/>\n"
    "<emitter type='area'><rgb name='radiance' value='2, 4, 8'/></emitter></shape>\n"
    "<shape type='obj'><string name='filename' value='tile.obj'/>\n"
    "<emitter type='area'><rgb name='radiance' value='5, 0, 5'/></emitter></shape>\n";

const char *const far_contents =
    "<shape type='obj'><string name='filename' value='far.obj'/></shape>\n";

/* Two materials of one model whose choices differ, so that the program cannot take them as known.
 */
const char *const mesh_contents =
    "<emitter type='envmap'><string name='filename' value='sky.exr'/>\n"
    "<transform name='to_world'><rotate x='0.6' z='0.8' angle='40'/></transform></emitter>\n"
    "<shape type='obj'><string name='filename' value='ball.obj'/><bsdf type='roughconductor'>\n"
    "<texture type='bitmap' name='alpha'><string name='filename' value='spots.png'/>"
    "<boolean name='raw' value='true'/></texture><ref id='sky' name='specular_reflectance'/>"
    "</bsdf></shape>\n"
    "<shape type='obj'><string name='filename' value='tile.obj'/>\n"
    "<emitter type='area'><rgb name='radiance' value='5, 0, 5'/></emitter></shape>\n"
    "<shape type='rectangle'><transform name='to_world'><scale value='2'/>\n"
    "<rotate x='1' angle='-90'/></transform><bsdf type='phong'>"
    "<texture type='bitmap' id='sky' name='diffuse_reflectance'>"
    "<string name='filename' value='sky.exr'/><string name='filter_type' value='nearest'/>"
    "</texture></bsdf></shape>\n"
    "<shape type='sphere'><point name='center' x='-1' y='0.3' z='1.2'/>\n"
    "<float name='radius' value='0.3'/><bsdf type='roughconductor'>"
    "<string name='distribution' value='blinn'/><string name='masking' value='vcavity'/>"
    "<float name='alpha' value='0.3'/></bsdf></shape>\n";

/* Two triangles as a light, and forty that are never met. */
static void write_tiles(void)
{
    char text[8192];
    int length = 0;
    scene_file_write("tile.obj", "v 1 0.01 1.5\nv 1.4 0.01 1.5\nv 1.4 0.4 1.6\nv 1 0.4 1.6\n"
                                 "f 1 2 3\nf 1 3 4\n");
    for (int i = 0; i < 40; ++i) {
        length += snprintf(text + length, sizeof text - (size_t)length,
                           "v %d 40 40\nv %d.001 40 40\nv %d 40.001 40\nf %d %d %d\n", i, i, i,
                           3 * i + 1, 3 * i + 2, 3 * i + 3);
    }
    scene_file_write("far.obj", text);
}

static void write_map(void)
{
    struct brdfcl_image map;
    struct brdf_error error;
    assert_int_equal(brdfcl_image_create(&map, 24, 13, &error), BRDF_OK);
    for (int i = 0; i < 24 * 13 * 3; ++i) {
        map.rgb[i] = (float)((i * 7919) % 101) / 100.0f;
    }
    map.rgb[3 * (24 * 3 + 5)] = 60.0f;
    assert_int_equal(brdfcl_image_write(&map, scene_file_write("sky.exr", ""), NULL, &error),
                     BRDF_OK);
    brdfcl_image_destroy(&map);
}

static void write_spots(void)
{
    struct brdfcl_image spots;
    struct brdf_error error;
    assert_int_equal(brdfcl_image_create(&spots, 13, 9, &error), BRDF_OK);
    for (int i = 0; i < 13 * 9 * 3; ++i) {
        spots.rgb[i] = (float)((i * 6389) % 97) / 96.0f;
    }
    assert_int_equal(brdfcl_image_write(&spots, scene_file_write("spots.png", ""), NULL, &error),
                     BRDF_OK);
    brdfcl_image_destroy(&spots);
}

/* A ball with bumps: `rings` rings of twice as many quads, each two triangles. */
static void write_ball(int rings)
{
    size_t size = 1u << 20;
    size_t used = 0;
    char *text = malloc(size);
    int round = 2 * rings + 1;
    assert_non_null(text);
#define PUT(...) (used += (size_t)snprintf(text + used, size - used, __VA_ARGS__))
    for (int i = 0; i < (rings + 1) * round; ++i) {
        double theta = pi * (0.02 + 0.96 * (i / round) / rings);
        double phi = pi * (i % round) / rings;
        double r = 0.8 + 0.1 * sin(5.0 * phi) * sin(theta);
        double n[3] = {sin(theta) * cos(phi), cos(theta), -sin(theta) * sin(phi)};
        PUT("v %.7g %.7g %.7g\n", r * n[0], r * n[1] + 0.9, r * n[2]);
        PUT("vn %.7g %.7g %.7g\n", n[0], n[1], n[2]);
        PUT("vt %.7g %.7g\n", (double)(i % round) / (round - 1), (double)(i / round) / rings);
    }
    for (int i = 0; i < rings * round; ++i) {
        int a = i + 1;
        int b = i + 1 + round;
        if (i % round < round - 1) {
            PUT("f %d/%d/%d %d/%d/%d %d/%d/%d\n", a, a, a, b, b, b, a + 1, a + 1, a + 1);
            PUT("f %d/%d/%d %d/%d/%d %d/%d/%d\n", a + 1, a + 1, a + 1, b, b, b, b + 1, b + 1,
                b + 1);
        }
    }
#undef PUT
    assert_true(used < size - 100);
    scene_file_write("ball.obj", text);
    free(text);
}

void render_files_write(void)
{
    write_tiles();
    write_map();
    write_spots();
    write_ball(16);
}
