/*
 * image_png.c - PNG files into pictures and back, with libpng.
 *
 * libpng reports errors by longjmp. Each direction keeps all its state in a struct that lives in
 * the caller of the function with the setjmp, so that nothing depends on local variables whose
 * values a longjmp leaves undefined.
 */
#include "image_formats.h"

#include <errno.h>
#include <math.h>
#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#define IHDR_END                                                                                   \
    24 /* bytes up to and with width and height: signature, length, type, two words                \
        */

struct png_job {
    png_structp png;
    png_infop info;
    const char *path;
    char message[256]; /* of libpng */
    char warning[256]; /* the last one; often says more than the error after it */
    brdf_status status;
    struct brdf_error *error;
    long long offset; /* in the file */
    unsigned char *bytes;
    png_bytep *rows; /* reading: pointers into bytes */
    /* reading */
    const struct brdfcl_image_source *source;
    struct brdfcl_image *target;
    /* writing */
    struct brdfcl_atomic_file *file;
    const struct brdfcl_image *image;
    const struct brdfcl_image_options *options;
};

static void on_error(png_structp png, png_const_charp message)
{
    struct png_job *job = png_get_error_ptr(png);
    snprintf(job->message, sizeof job->message, "%s", message);
    png_longjmp(png, 1);
}

static void on_warning(png_structp png, png_const_charp message)
{
    struct png_job *job = png_get_error_ptr(png);
    snprintf(job->warning, sizeof job->warning, "%s", message);
}

/* After a longjmp: an error that is already told about stays, else it is what libpng said. */
static brdf_status fail(struct png_job *job, brdf_status status, const char *what)
{
    int warned = job->warning[0] != '\0';
    if (job->status != BRDF_OK)
        return job->status;
    if (strstr(job->message, "memory"))
        status = BRDF_OUT_OF_MEMORY;
    return brdf_fail(job->error, status, "%s: %s: %s%s%s%s", job->path, what, job->message,
                     warned ? " (" : "", job->warning, warned ? ")" : "");
}

/* --- the sRGB curve, IEC 61966-2-1 --- */

static double srgb_decode(double encoded)
{
    return encoded <= 0.04045 ? encoded / 12.92 : pow((encoded + 0.055) / 1.055, 2.4);
}

static double srgb_encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1.0 / 2.4) - 0.055;
}

/* --- reading --- */

static void on_read(png_structp png, png_bytep buffer, size_t size)
{
    struct png_job *job = png_get_io_ptr(png);
    long long n = brdfcl_image_source_read(job->source, buffer, size, job->offset);
    if (n < 0)
        job->status =
            brdf_fail(job->error, BRDF_IO, "%s: cannot be read: %s", job->path, strerror(errno));
    else if ((size_t)n < size)
        job->status = brdf_fail(job->error, BRDF_BAD_FILE,
                                "%s: is cut short: PNG data beyond its end at byte %lld", job->path,
                                job->source->size);
    if (n < 0 || (size_t)n < size)
        png_error(png, "cut short");
    job->offset += n;
}

/* Width and height come first in the file: refuse them before libpng reads on. */
static brdf_status check_size(const struct png_job *job)
{
    unsigned char head[IHDR_END];
    long long n = brdfcl_image_source_read(job->source, head, sizeof head, 0);
    if (n < (long long)sizeof head)
        return brdf_fail(job->error, BRDF_BAD_FILE, "%s: is cut short: it ends at byte %lld",
                         job->path, job->source->size);
    if (memcmp(head + 12, "IHDR", 4) != 0)
        return brdf_fail(job->error, BRDF_BAD_FILE, "%s: not valid PNG: no IHDR chunk at byte 8",
                         job->path);
    return brdfcl_image_size_check(job->path, (long long)png_get_uint_32(head + 16),
                                   (long long)png_get_uint_32(head + 20), job->error);
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

static void decode_pixels(const struct png_job *job, int depth, float *rgb, size_t count)
{
    float table[256];
    if (depth == 16) {
        for (size_t i = 0; i < count; i++) {
            unsigned value = (unsigned)job->bytes[2 * i] << 8 | job->bytes[2 * i + 1];
            rgb[i] = (float)(job->source->raw ? value / 65535.0 : srgb_decode(value / 65535.0));
        }
        return;
    }
    brdfcl_image_codes(job->source->raw, table);
    for (size_t i = 0; i < count; i++)
        rgb[i] = table[job->bytes[i]];
}

/* Everything that may longjmp while reading. Not 0: the rows are in job->bytes, or job->status. */
static int read_rows(struct png_job *job)
{
    if (setjmp(png_jmpbuf(job->png)))
        return 0;
    png_set_read_fn(job->png, job, on_read);
    png_set_user_limits(job->png, BRDFCL_IMAGE_SIDE_MAX, BRDFCL_IMAGE_SIDE_MAX);
    png_read_info(job->png, job->info);
    ask_for_rgb(job->png);
    png_read_update_info(job->png, job->info);
    const png_uint_32 height = png_get_image_height(job->png, job->info);
    const size_t stride = png_get_rowbytes(job->png, job->info);
    job->bytes = calloc(height, stride);
    job->rows = calloc(height, sizeof *job->rows);
    if (!job->bytes || !job->rows)
        png_error(job->png, "out of memory");
    for (png_uint_32 y = 0; y < height; y++)
        job->rows[y] = job->bytes + y * stride;
    png_read_image(job->png, job->rows);
    png_read_end(job->png, NULL);
    return 1;
}

static brdf_status read_picture(struct png_job *job)
{
    brdf_status status = check_size(job);
    if (status != BRDF_OK)
        return status;
    if (!read_rows(job))
        return fail(job, BRDF_BAD_FILE, "not valid PNG");
    const int depth = png_get_bit_depth(job->png, job->info);
    const int width = (int)png_get_image_width(job->png, job->info);
    const int height = (int)png_get_image_height(job->png, job->info);
    if (png_get_channels(job->png, job->info) != 3 || (depth != 8 && depth != 16))
        return brdf_fail(job->error, BRDF_UNSUPPORTED, "%s: a PNG of an unknown kind", job->path);
    status = brdfcl_image_create(job->target, width, height, job->error);
    if (status == BRDF_OK)
        decode_pixels(job, depth, job->target->rgb, (size_t)width * (size_t)height * 3);
    if (job->source->bits)
        *job->source->bits = depth;
    return status;
}

brdf_status brdfcl_image_read_png(struct brdfcl_image *image,
                                  const struct brdfcl_image_source *source,
                                  struct brdf_error *error)
{
    struct png_job job;
    brdf_status status;
    memset(&job, 0, sizeof job);
    job.path = source->path;
    job.source = source;
    job.target = image;
    job.error = error;
    job.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
    job.info = job.png ? png_create_info_struct(job.png) : NULL;
    if (job.info)
        status = read_picture(&job);
    else
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: libpng cannot be set up", source->path);
    png_destroy_read_struct(&job.png, &job.info, NULL);
    free(job.rows);
    free(job.bytes);
    return status;
}

/* --- writing --- */

static void on_write(png_structp png, png_bytep data, size_t size)
{
    struct png_job *job = png_get_io_ptr(png);
    job->status = brdfcl_atomic_write(job->file, data, size, job->offset, job->error);
    if (job->status != BRDF_OK)
        png_error(png, "not written");
    job->offset += (long long)size;
}

static void on_flush(png_structp png)
{
    (void)png;
}

static void encode_row(const struct png_job *job, int y, double scale)
{
    const size_t count = (size_t)job->image->width * 3;
    const float *row = job->image->rgb + (size_t)y * count;
    for (size_t i = 0; i < count; i++) {
        const double value = (double)row[i] * scale;
        /* Written so that NaN falls through to black. */
        const double inside = value > 0.0 ? (value < 1.0 ? value : 1.0) : 0.0;
        job->bytes[i] = (unsigned char)(srgb_encode(inside) * 255.0 + 0.5);
    }
}

static void put_text(struct png_job *job, const struct brdfcl_image_metadata *entry)
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
    png_set_text(job->png, job->info, &text, 1);
}

/* Everything that may longjmp while writing. */
static int write_rows(struct png_job *job)
{
    if (setjmp(png_jmpbuf(job->png)))
        return 0;
    const double scale = exp2((double)job->options->exposure);
    const png_uint_32 width = (png_uint_32)job->image->width;
    const png_uint_32 height = (png_uint_32)job->image->height;
    png_set_write_fn(job->png, job, on_write, on_flush);
    png_set_user_limits(job->png, BRDFCL_IMAGE_SIDE_MAX, BRDFCL_IMAGE_SIDE_MAX);
    png_set_IHDR(job->png, job->info, width, height, 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB_gAMA_and_cHRM(job->png, job->info, PNG_sRGB_INTENT_PERCEPTUAL);
    for (int i = 0; i < job->options->metadata_count; i++)
        put_text(job, &job->options->metadata[i]);
    png_write_info(job->png, job->info);
    job->bytes = calloc(width, 3);
    if (!job->bytes)
        png_error(job->png, "out of memory");
    for (int y = 0; y < job->image->height; y++) {
        encode_row(job, y, scale);
        png_write_row(job->png, job->bytes);
    }
    png_write_end(job->png, job->info);
    return 1;
}

brdf_status brdfcl_image_write_png(const struct brdfcl_image *image,
                                   const struct brdfcl_image_options *options,
                                   struct brdfcl_atomic_file *file, struct brdf_error *error)
{
    struct png_job job;
    brdf_status status = BRDF_OK;
    memset(&job, 0, sizeof job);
    job.path = file->path;
    job.file = file;
    job.image = image;
    job.options = options;
    job.error = error;
    job.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &job, on_error, on_warning);
    job.info = job.png ? png_create_info_struct(job.png) : NULL;
    if (!job.info)
        status = brdf_fail(error, BRDF_OUT_OF_MEMORY, "%s: libpng cannot be set up", file->path);
    else if (!write_rows(&job))
        status = fail(&job, BRDF_IO, "cannot be written as PNG");
    png_destroy_write_struct(&job.png, &job.info);
    free(job.bytes);
    return status;
}
