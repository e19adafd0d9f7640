/*
 * texture_record.h - how textures lie in the scene array, and how they are tied to parameters.
 *
 * A texture is a record; the texels of a bitmap are words of the scene array, too. A binding says
 * that a texture sets one parameter of a surface; the bindings of a surface stand one after another
 * in the order of the words that they set.
 */
#ifndef PT_TEXTURE_RECORD_H
#define PT_TEXTURE_RECORD_H

enum pt_texture_kind { PT_TEXTURE_BITMAP, PT_TEXTURE_CHECKERBOARD };

/* What lies outside of the unit square. */
enum pt_texture_wrap { PT_WRAP_REPEAT, PT_WRAP_MIRROR, PT_WRAP_CLAMP };

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

    /* Checkerboard. */
    float color0[3];
    float color1[3];
};

struct pt_binding {
    int texture; /* its number */
    float low;   /* the parameter's range, to which the texture's values are clamped */
    float high;
    int padding;
};

#endif
