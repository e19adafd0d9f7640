/*
 * scene.h - how a scene lies in memory: records of 4-byte words, the same bytes on host and device.
 *
 * One array of words holds everything that a path can meet; struct pt_settings says at which word
 * each part begins. Integers lie in it as their bits. Records of 16 words start on 64 bytes, one
 * cache line, so that reading one record touches one line (rows.h reads a packet of them at once).
 */
#ifndef PT_SCENE_H
#define PT_SCENE_H

#include "brdf/dialect.h"
#include "brdf/stored.h"

#define PT_ROW 16 /* words in a record */

/* Primitives, a row each. Planar ones are p + u e1 + v e2 with a rule for (u, v). */
#define PT_TRIANGLE 0  /* u >= 0, v >= 0, u + v <= 1; p, e1, e2 = vertex 0 and the edges from it */
#define PT_RECTANGLE 1 /* 0 <= u, v <= 1; p = one corner */
#define PT_DISK 2      /* u^2 + v^2 <= 1; p = centre, e1 and e2 = two conjugate radii */
#define PT_SPHERE 3    /* p = centre; e1, e2 = its x and y axes, length = the radius */

enum pt_primitive_word {
    PT_P = 0,          /* 3 words: see above */
    PT_E1 = 3,         /* 3 words */
    PT_E2 = 6,         /* 3 words */
    PT_KIND = 9,       /* int: PT_TRIANGLE ... */
    PT_SURFACE = 10,   /* int: key of the surface or fork */
    PT_SHADING = 11,   /* int: row of normals and texture coordinates, or -1 (triangles only) */
    PT_FLIP = 12,      /* float: 1 or -1, multiplies the normal e1 x e2 (sphere: outward) */
    PT_RADIUS = 13,    /* float: of a sphere, else 0 */
    PT_LIGHT_PDF = 14, /* float: probability that next-event estimation chooses it; 0 = no light */
    PT_MIRRORED = 15   /* float: of a sphere whose axes are left-handed 1, else 0 */
};

/* Shading of a triangle: what is interpolated over it. */
enum pt_shading_word {
    PT_NORMALS = 0, /* 9 words: unit normals of the vertices 0, 1, 2, after PT_FLIP */
    PT_UVS = 9      /* 6 words: texture coordinates of the vertices */
};

/*
 * The primitives once more, made ready for intersection (intersect.h), a row each: what a packet of
 * rays goes through where there are few of them. Planar ones hold their pt_plane; spheres their
 * centre and radius.
 */
enum pt_ready_word {
    PT_READY_P = 0,       /* 3 words */
    PT_READY_N = 3,       /* 3 words; of a sphere: its radius, 0, 0 */
    PT_READY_A = 6,       /* 3 words */
    PT_READY_B = 9,       /* 3 words */
    PT_READY_KIND = 12,   /* int */
    PT_READY_SURFACE = 13 /* int */
};

/* A light, a row each: a primitive that emits, or the environment (kind -1). */
enum pt_light_word {
    PT_LIGHT_KIND = 9, /* words 0 to 8 as in the primitive; int: kind, or -1 for the environment */
    PT_LIGHT_RADIANCE = 10, /* 3 words, linear Rec. 709 [W/(m^2 sr)] */
    PT_LIGHT_SELECT = 13,   /* float: probability of being chosen */
    PT_LIGHT_RADIUS = 14,   /* float: of a sphere */
    PT_LIGHT_FLIP = 15      /* float: 1 or -1, the side that emits */
};

/* A surface: a material and what it emits; all 4-byte words. */
struct pt_surface {
    struct brdf_material material;
    float radiance[3]; /* 0 where it does not emit */
    int emits;
    int variant;      /* the specialised shading kernel: equal model, flags, choices and bindings */
    int bindings;     /* texture_record.h: their first word in the scene array, if it has any */
    int tilt_texture; /* of a normal or bump map, where the variant has one */
    float tilt_scale; /* of a bump map: height of 1 in it [world units] */
};

/*
 * A fork: where a path goes on to one of two surfaces or further forks, at random (resolve.h). Keys
 * number both: surfaces from 0, then surface_count for "missed", then forks. A fork comes after
 * those it leads to.
 */
struct pt_fork {
    int first; /* keys */
    int second;
    int kind;     /* enum pt_fork_kind */
    int texture;  /* PT_FORK_TEXTURE: its number */
    float weight; /* PT_FORK_SHARE: probability of the second */
    int padding[3];
};

enum pt_fork_kind {
    PT_FORK_SHARE,   /* the second is taken with a probability */
    PT_FORK_TEXTURE, /* with one that a texture gives */
    PT_FORK_SIDE     /* the second is the back */
};

/* How a variant tilts its shading frame (tilt.h): not at all, or the sum of these. */
enum pt_tilt_how {
    PT_TILT_NORMAL = 1,   /* by a normal map */
    PT_TILT_BUMP = 2,     /* by a bump map */
    PT_TILT_FACE = 4,     /* normals that face away are turned to the viewer */
    PT_TILT_SHADOW = 8,   /* facets shadow each other */
    PT_TILT_TWOSIDED = 16 /* the back is the mirror image of the front, before it is tilted */
};

/* Features: what a scene has, as bits; kernels are compiled for exactly these. */
#define PT_HAS_SPHERES 2 /* spheres */
#define PT_HAS_SHADING 4 /* triangles with normals or texture coordinates */
#define PT_HAS_LIGHTS 8  /* primitives that emit */
#define PT_HAS_SPHERE_LIGHTS 16
#define PT_HAS_CONSTANT 32 /* a constant environment */
#define PT_HAS_MAP 64      /* an environment map */
#define PT_HAS_BVH 128     /* enough primitives for a hierarchy */
#define PT_HAS_SOBOL 256   /* Owen-scrambled Sobol; else independent random numbers */
#define PT_HAS_TEXTURES 512
#define PT_HAS_BITMAPS 1024      /* textures of that kind */
#define PT_HAS_FLOAT_TEXELS 2048 /* bitmaps that are not of 8 bits */
#define PT_HAS_WOODGRAINS 16384
#define PT_HAS_FORKS 4096        /* surfaces that are put together from others */
#define PT_HAS_PLACED_FORKS 8192 /* forks that ask where on the surface a path is */

/* Reconstruction filters. */
#define PT_FILTER_BOX 0
#define PT_FILTER_TENT 1
#define PT_FILTER_GAUSSIAN 2

struct pt_settings {
    /* Camera: a ray through the film at (x, y) in [0, 1]^2 (y down) starts at camera_origin and
       runs along camera_corner + x camera_right + y camera_down, normalised. World space. */
    float camera_origin[3];
    float camera_corner[3];
    float camera_right[3];
    float camera_down[3];
    int width;  /* pixels */
    int height; /* pixels */
    int seed;
    int max_depth;       /* path segments at most; as in Mitsuba, 1 = only what emits is seen */
    int rr_depth;        /* Russian roulette from this depth on */
    int filter;          /* PT_FILTER_... */
    float filter_radius; /* pixels */
    float filter_sigma;  /* pixels, gaussian */
    int features;        /* PT_HAS_... */

    /* Where the parts begin, in words of the scene array, and how many records they hold. */
    int primitives;
    int primitive_count;
    int ready; /* the primitives made ready; only where there is no hierarchy */
    int shading;
    int surfaces;
    int surface_count;
    int textures; /* texture_record.h */
    int forks;
    int fork_count;
    int lights;
    int light_cdf; /* light_count + 1 words, from 0 to 1 */
    int light_count;
    int light_steps; /* steps of the binary search in light_cdf */
    int nodes;       /* bvh.h */
    int leaves;
    int root;

    /* Environment: a constant, or a map (environment.h). */
    float environment_radiance[3];
    float environment_select;      /* probability of choosing it as the light */
    float environment_to_world[9]; /* rotation, row-major: map -> world; its transpose goes back */
    int environment_width;         /* pixels */
    int environment_height;
    int environment_texels;  /* 4 words each: r, g, b, unused */
    int environment_rows;    /* CDF over the height - 1 rows of cells: height words */
    int environment_columns; /* a CDF for each row of cells: (height - 1) x (width + 1) words */
    int environment_row_steps;
    int environment_column_steps;

    /* Where the queues lie, in words of the queue array (path.h). */
    int active[2];      /* path numbers to extend now, and next */
    int keys;           /* the surface that each active path met */
    int histograms;     /* a count a surface for each block that sorts */
    int packet_surface; /* for each packet, grouped by variant */
    int packet_paths;   /* BRDF_LANES path numbers for each packet */
    int variant_first;  /* first packet of each variant */
    int variant_count;
    int pool; /* paths in flight; the record behind the last is scratch for idle lanes */

    /* Where the parts of the state array begin, in words; paths are at 0. */
    int radiance;
    int shadows;
    int queues;
};

#endif
