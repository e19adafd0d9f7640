/*
 * image_png_read.c - PNG files into pictures, with libpng.
 */
#include "image_png.h"

#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdlib.h>
#include <string.h>

/* Bytes up to and with width and height: signature, length, type, two words. */
#define IHDR_END 24

struct png_reader {
    struct png_job base;
    const struct brdfcl_image_source *source;
    struct brdfcl_image *target;
    unsigned char *bytes;
    png_bytep *rows; /* pointers into bytes */
};

/* The sRGB curve, IEC 61966-2-1. */
static double srgb_decode(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

static void on_read(png_structp png, png_bytep buffer, size_t size)
{
    struct png_reader *reader = png_get_io_ptr(png);
    long long n = brdfcl_image_source_read(reader->source, buffer, size, reader->base.offset);
    if (n < 0)
        reader->base.status = brdf_fail(reader->base.error, BRDF_IO, "%s: cannot be read: %s",
                                        reader->base.path, strerror(errno));
    else if ((size_t)n < size)
        reader->base.status = brdf_fail(reader->base.error, BRDF_BAD_FILE,
                                        "%s: is cut short: PNG data beyond its end at byte %lld",
                                        reader->base.path, reader->source->size);
    if (n < 0 || (size_t)n < size)
        png_error(png, "cut short");
    reader->base.offset += n;
}

/* Width and height come first in the file: refuse them before libpng reads on. */
static brdf_status check_size(const struct png_reader *reader)
{
    unsigned char head[IHDR_END];
    long long n = brdfcl_image_source_read(reader->source, head, sizeof head, 0);
    if (n < (long long)sizeof head)
        return brdf_fail(reader->base.error, BRDF_BAD_FILE,
                         "%s: is cut short: it ends at byte %lld", reader->base.path,
                         reader->source->size);
    if (memcmp(head + 12, "IHDR", 4) != 0)
        return brdf_fail(reader->base.error, BRDF_BAD_FILE,
                         "%s: not valid PNG: no IHDR chunk at byte 8", reader->base.path);
    return brdfcl_image_size_check(reader->base.path, (long long)png_get_uint_32(head + 16),
                                   (long long)png_get_uint_32(head + 20), reader->base.error);
}

/* Ask libpng for red, green, blue of 8 or 16 bits, whatever the file holds. */
static void ask_for_rgb(png_structp png)
{
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    png_set_strip_alpha(png);
    png_set_interlace_handling(png);
}

void brdfcl_image_codes(int raw, float table[256])
{
    for (int i = 0; i < 256; i++)
        table[i] = (float)(raw ? i / 255.0 : srgb_decode(i / 255.0));
}

static void decode_pixels(const struct png_reader *reader, int depth, float *rgb, size_t count)
{
    float table[256];
    if (depth == 16) {
        for (size_t i = 0; i < count; i++) {
            unsigned value = (unsigned)reader->bytes[2 * i] << 8 | reader->bytes[2 * i + 1];
            rgb[i] = (float)(reader->source->raw ? value / 65535.0 : srgb_decode(value / 65535.0));
        }
        return;
    }
    brdfcl_image_codes(reader->source->raw, table);
    for (size_t i = 0; i < count; i++)
        rgb[i] = table[reader->bytes[i]];
}

/* Everything that may longjmp while reading. 1: the rows are in reader->bytes; 0: it failed. */
static int read_rows(struct png_reader *reader)
{
    if (setjmp(png_jmpbuf(reader->base.png)))
        return 0;
    png_set_read_fn(reader->base.png, reader, on_read);
    png_set_user_limits(reader->base.png, BRDFCL_IMAGE_SIDE_MAX, BRDFCL_IMAGE_SIDE_MAX);
    png_read_info(reader->base.png, reader->base.info);
    ask_for_rgb(reader->base.png);
    png_read_update_info(reader->base.png, reader->base.info);
    const png_uint_32 height = png_get_image_height(reader->base.png, reader->base.info);
    const size_t stride = png_get_rowbytes(reader->base.png, reader->base.info);
    reader->bytes = calloc(height, stride);
    reader->rows = calloc(height, sizeof *reader->rows);
    if (!reader->bytes || !reader->rows)
        png_error(reader->base.png, "out of memory");
    for (png_uint_32 y = 0; y < height; y++)
        reader->rows[y] = reader->bytes + y * stride;
    png_read_image(reader->base.png, reader->rows);
    png_read_end(reader->base.png, NULL);
    return 1;
}

static brdf_status read_picture(struct png_reader *reader)
{
    brdf_status status = check_size(reader);
    if (status != BRDF_OK)
        return status;
    if (!read_rows(reader))
        return brdfcl_png_fail(&reader->base, BRDF_BAD_FILE, "not valid PNG");
    const int depth = png_get_bit_depth(reader->base.png, reader->base.info);
    const int width = (int)png_get_image_width(reader->base.png, reader->base.info);
    const int height = (int)png_get_image_height(reader->base.png, reader->base.info);
    if (png_get_channels(reader->base.png, reader->base.info) != 3 || (depth != 8 && depth != 16))
        return brdf_fail(reader->base.error, BRDF_UNSUPPORTED, "%s: a PNG of an unknown kind",
                         reader->base.path);
    status = brdfcl_image_create(reader->target, width, height, reader->base.error);
    if (status == BRDF_OK)
        decode_pixels(reader, depth, reader->target->rgb, (size_t)width * (size_t)height * 3);
    if (reader->source->bits)
        *reader->source->bits = depth;
    return status;
}

brdf_status brdfcl_image_read_png(struct brdfcl_image *image,
                                  const struct brdfcl_image_source *source,
                                  struct brdf_error *error)
{
    struct png_reader reader;
    brdf_status status;
    memset(&reader, 0, sizeof reader);
    reader.base.path = source->path;
    reader.source = source;
    reader.target = image;
    reader.base.error = error;
    reader.base.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &reader.base, brdfcl_png_error,
                                             brdfcl_png_warning);
    reader.base.info = reader.base.png ? png_create_info_struct(reader.base.png) : NULL;
    if (reader.base.info)
        status = read_picture(&reader);
    else
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: libpng cannot be set up", source->path);
    png_destroy_read_struct(&reader.base.png, &reader.base.info, NULL);
    free(reader.rows);
    free(reader.bytes);
    return status;
}
