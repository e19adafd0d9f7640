/*
 * texture_record.h - how textures lie in the scene array, and how they are tied to parameters.
 *
 * A texture is a record; the texels of a bitmap are words of the scene array, too. A binding says
 * that a texture sets one parameter of a surface; the bindings of a surface stand one after another
 * in the order of the words that they set.
 */
#ifndef PT_TEXTURE_RECORD_H
#define PT_TEXTURE_RECORD_H

enum pt_texture_kind { PT_TEXTURE_BITMAP, PT_TEXTURE_CHECKERBOARD, PT_TEXTURE_WOODGRAIN };

/* What lies outside of the unit square. */
enum pt_texture_wrap { PT_WRAP_REPEAT, PT_WRAP_MIRROR, PT_WRAP_CLAMP };

/* What a woodgrain sets: the other kinds have one value for all. */
enum pt_grain_output {
    PT_GRAIN_COLOR,
    PT_GRAIN_FIBER_COLOR,
    PT_GRAIN_FIBER_AXIS, /* as a colour c: 2 c - 1 is the direction in the local frame */
    PT_GRAIN_BETA,
    PT_GRAIN_ALPHA,
    PT_GRAIN_LATE,
    PT_GRAIN_OUTPUTS
};

enum pt_grain_size {
    PT_GRAIN_RING,          /* distance of two rings [units of the log, as all lengths] */
    PT_GRAIN_WANDER,        /* by how much of it their borders wander */
    PT_GRAIN_FIGURE,        /* tangent of the fibres' steepest slope against the trunk's axis */
    PT_GRAIN_FIGURE_LENGTH, /* between two bends */
    PT_GRAIN_STREAKS,       /* how much darker the darkest streaks are, 0 to 1 */
    PT_GRAIN_SIZES
};

/* All 4-byte words. */
struct pt_texture {
    int kind;       /* enum pt_texture_kind */
    float to_uv[6]; /* 2 x 3, row-major: (u, v, 1) of the surface -> the texture's coordinates */

    /* Bitmap; texel (x, y) is number y width + x, and row 0 lies at v = 0. */
    int width;
    int height;
    int texels;  /* first word in the scene array */
    int decode;  /* 256 words there: a texel is one word, 8 bits a channel, red lowest, and these
                    are their values; -1: a texel is a quad r, g, b, unused */
    int nearest; /* else bilinear */
    int wrap;    /* enum pt_texture_wrap */

    /* Checkerboard; of a woodgrain early and late wood, as each pair below. */
    float color0[3];
    float color1[3];

    /* Woodgrain. */
    int output; /* enum pt_grain_output, where nothing else asks for one */
    int seed;
    float log_from_world[12]; /* 3 x 4, row-major; the trunk's axis is z */
    float world_from_log[9];  /* 3 x 3: of directions */
    float sizes[PT_GRAIN_SIZES];
    float fiber0[3];
    float fiber1[3];
    float beta[2];
    float alpha[2];
};

struct pt_binding {
    int texture; /* its number */
    int output;  /* of a woodgrain */
    float low;   /* the parameter's range, to which the texture's values are clamped */
    float high;
};

#endif
