/*
 * image_png_write.c - pictures into PNG files of 8 bits, with libpng.
 */
#include "image_png.h"

#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct png_writer {
    struct png_job base;
    struct brdfcl_atomic_file *file;
    const struct brdfcl_image *image;
    const struct brdfcl_image_options *options;
    unsigned char *bytes; /* of one row */
};

/* The sRGB curve, IEC 61966-2-1. */
static double srgb_encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

static void on_write(png_structp png, png_bytep data, size_t size)
{
    struct png_writer *writer = png_get_io_ptr(png);
    writer->base.status =
        brdfcl_atomic_write(writer->file, data, size, writer->base.offset, writer->base.error);
    if (writer->base.status != BRDF_OK)
        png_error(png, "not written");
    writer->base.offset += (long long)size;
}

static void on_flush(png_structp png)
{
    (void)png;
}

static void encode_row(const struct png_writer *writer, int y, double scale)
{
    const size_t count = (size_t)writer->image->width * 3;
    const float *row = writer->image->rgb + (size_t)y * count;
    for (size_t i = 0; i < count; i++) {
        const double value = (double)row[i] * scale;
        /* Written so that NaN falls through to black. */
        const double inside = value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0;
        writer->bytes[i] = (unsigned char)(srgb_encode(inside) * 255.0 + 0.5);
    }
}

static void put_text(struct png_writer *writer, const struct brdfcl_image_metadata *entry)
{
    char number[32];
    char name[80]; /* libpng's structs are not const, though it does not write to these */
    png_text text;
    memset(&text, 0, sizeof text);
    snprintf(name, sizeof name, "%s", entry->name);
    text.key = name;
    text.text = number;
    text.compression = PNG_TEXT_COMPRESSION_NONE;
    if (entry->kind == BRDFCL_METADATA_INT)
        snprintf(number, sizeof number, "%d", entry->value.integer);
    else if (entry->kind == BRDFCL_METADATA_FLOAT)
        snprintf(number, sizeof number, "%.9g", (double)entry->value.number);
    else
        text.text = (char *)entry->value.text;
    /* tEXt is Latin-1; iTXt is UTF-8. */
    for (const char *c = text.text; *c; c++)
        if ((unsigned char)*c >= 0x80)
            text.compression = PNG_ITXT_COMPRESSION_NONE;
    png_set_text(writer->base.png, writer->base.info, &text, 1);
}

/* Everything that may longjmp while writing. */
static int write_rows(struct png_writer *writer)
{
    if (setjmp(png_jmpbuf(writer->base.png)))
        return 0;
    const double scale = exp2((double)writer->options->exposure);
    const png_uint_32 width = (png_uint_32)writer->image->width;
    const png_uint_32 height = (png_uint_32)writer->image->height;
    png_set_write_fn(writer->base.png, writer, on_write, on_flush);
    png_set_user_limits(writer->base.png, BRDFCL_IMAGE_SIDE_MAX, BRDFCL_IMAGE_SIDE_MAX);
    png_set_IHDR(writer->base.png, writer->base.info, width, height, 8, PNG_COLOR_TYPE_RGB,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(writer->base.png, writer->base.info, PNG_sRGB_INTENT_PERCEPTUAL);
    for (int i = 0; i < writer->options->metadata_count; i++)
        put_text(writer, &writer->options->metadata[i]);
    png_write_info(writer->base.png, writer->base.info);
    writer->bytes = calloc(width, 3);
    if (!writer->bytes)
        png_error(writer->base.png, "out of memory");
    for (int y = 0; y < writer->image->height; y++) {
        encode_row(writer, y, scale);
        png_write_row(writer->base.png, writer->bytes);
    }
    png_write_end(writer->base.png, writer->base.info);
    return 1;
}

brdf_status brdfcl_image_write_png(const struct brdfcl_image *image,
                                   const struct brdfcl_image_options *options,
                                   struct brdfcl_atomic_file *file, struct brdf_error *error)
{
    struct png_writer writer;
    brdf_status status = BRDF_OK;
    memset(&writer, 0, sizeof writer);
    writer.base.path = file->path;
    writer.file = file;
    writer.image = image;
    writer.options = options;
    writer.base.error = error;
    writer.base.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &writer.base, brdfcl_png_error,
                                              brdfcl_png_warning);
    writer.base.info = writer.base.png ? png_create_info_struct(writer.base.png) : NULL;
    if (!writer.base.info)
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: libpng cannot be set up", file->path);
    else if (!write_rows(&writer))
        status = brdfcl_png_fail(&writer.base, BRDF_IO, "cannot be written as PNG");
    png_destroy_write_struct(&writer.base.png, &writer.base.info);
    free(writer.bytes);
    return status;
}
