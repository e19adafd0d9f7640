/*
 * image.h - pictures in memory, and the OpenEXR and PNG files that hold them.
 *
 * A picture is linear light with the primaries of Rec. 709 (those of sRGB), three floats a pixel.
 * Functions here keep no state: different images may be used on different threads at a time.
 */
#ifndef BRDFCL_IMAGE_H
#define BRDFCL_IMAGE_H

#include <brdf/status.h>
#include <brdfcl/api.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The largest picture: pixels in all, and pixels along one side. Read and written files alike. */
#define BRDFCL_IMAGE_PIXELS_MAX (1L << 28)
#define BRDFCL_IMAGE_SIDE_MAX (1L << 20)

struct brdfcl_image {
    int width;  /* pixels */
    int height; /* pixels */
    float *rgb; /* width * height * 3, rows from the top, pixels from the left; owned, malloc'd */
};

enum brdfcl_metadata_kind { BRDFCL_METADATA_TEXT, BRDFCL_METADATA_INT, BRDFCL_METADATA_FLOAT };

/*
 * One fact about a picture that goes into its file: an attribute of that type in OpenEXR, a text
 * chunk in PNG. Everything is borrowed for the time of the call.
 */
struct brdfcl_image_metadata {
    const char
        *name; /* 1 to 31 letters, digits, _ - . ; not a name that OpenEXR keeps for itself */
    enum brdfcl_metadata_kind kind; /* which member of value holds */
    union {
        const char *text; /* UTF-8, not NULL */
        int integer;
        float number;
    } value;
};

/* All zero is the default: floats of 32 bits, no exposure, no metadata. */
struct brdfcl_image_options {
    int half; /* OpenEXR: not 0 stores 16-bit floats; finite values beyond 65504 become that */
    float exposure; /* PNG: stops (EV); colours are multiplied by 2^exposure; finite */
    const struct brdfcl_image_metadata *metadata; /* metadata_count of them, borrowed */
    int metadata_count;                           /* >= 0 */
};

/*
 * Make a black picture. Width and height must be 1 or more and within the limits above. Whatever
 * the image held before is overwritten, not freed; if this fails it is left empty.
 * BRDF_OUT_OF_RANGE, BRDF_OUT_OF_MEMORY.
 */
BRDFCL_API brdf_status brdfcl_image_create(struct brdfcl_image *image, int width, int height,
                                           struct brdf_error *error);

/* Free the pixels and leave the image empty. An empty image or NULL may be given. */
BRDFCL_API void brdfcl_image_destroy(struct brdfcl_image *image);

/*
 * Read a picture; what the file is shows in its first bytes, not in its name. Image is overwritten,
 * to be destroyed by the caller; if this fails it is left empty.
 *
 * OpenEXR: every compression; channels R, G, B or else Y, of any type; lines or tiles (level 0). Of
 * several parts the first that has these channels is taken. The picture is the display window:
 * pixels that the data window lacks are black, pixels beyond it are dropped. Other channels (alpha,
 * depth) are ignored. Primaries other than those of Rec. 709 are refused, not misread.
 * PNG: every colour type, at 1 to 16 bits, is read as sRGB and made linear; alpha and the gAMA and
 * iCCP chunks are ignored.
 *
 * BRDF_IO, BRDF_BAD_FILE, BRDF_UNSUPPORTED (deep or subsampled OpenEXR, other primaries),
 * BRDF_OUT_OF_MEMORY; the message names the file.
 */
BRDFCL_API brdf_status brdfcl_image_read(struct brdfcl_image *image, const char *path,
                                         struct brdf_error *error);

/*
 * Write a picture as OpenEXR (.exr: ZIP, lines) or PNG (.png: sRGB, 8 bits; colours outside 0..1
 * are clamped, NaN is black), as the suffix says in whatever case. Options may be NULL.
 *
 * The file appears whole or not at all: it is written under another name in its folder,
 * `.NAME.XXXXXX.tmp`, and renamed when it is safe on the disk. If that fails, what stood there
 * before still stands, and nothing else is left. A symbolic link is followed, an existing file
 * keeps its permissions; a device or a pipe is refused.
 *
 * BRDF_UNSUPPORTED (another suffix), BRDF_BAD_ARGUMENT (options, or an empty image), BRDF_IO,
 * BRDF_OUT_OF_MEMORY.
 */
BRDFCL_API brdf_status brdfcl_image_write(const struct brdfcl_image *image, const char *path,
                                          const struct brdfcl_image_options *options,
                                          struct brdf_error *error);

/*
 * Would brdfcl_image_write be able to write here? To be asked before a long render: checks the
 * suffix, that the folder exists and may be written, and that the path is not itself a folder, a
 * device or a file that may not be written. Leaves no trace. BRDF_UNSUPPORTED, BRDF_IO.
 */
BRDFCL_API brdf_status brdfcl_image_path_check(const char *path, struct brdf_error *error);

/*
 * FNV-1a, 64 bits, over width and height (32 bits each) and then the bits of the floats, all with
 * the least significant byte first: the same on every machine, for the same bits.
 */
BRDFCL_API unsigned long long brdfcl_image_hash(const struct brdfcl_image *image);

#ifdef __cplusplus
}
#endif

#endif
