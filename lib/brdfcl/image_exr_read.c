/*
 * image_exr_read.c - OpenEXR files into pictures, with the C core of OpenEXR.
 *
 * A file is decoded chunk by chunk (a few lines, or a tile) into planes, one a colour, and from
 * there copied to its place in the display window.
 */
#define _POSIX_C_SOURCE 200809L

#include "image_exr.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- what OpenEXR calls --- */

static int64_t on_read(exr_const_context_t context, void *user, void *buffer, uint64_t size,
                       uint64_t offset, exr_stream_error_func_ptr_t report)
{
    struct exr_reader *reader = user;
    (void)context;
    (void)report;
    if (offset > LLONG_MAX || size > LLONG_MAX - offset)
        return -1;
    long long n = brdfcl_image_source_read(reader->source, buffer, (size_t)size, (long long)offset);
    if (n < 0)
        reader->read_errno = errno;
    return n;
}

static int64_t on_size(exr_const_context_t context, void *user)
{
    const struct exr_reader *reader = user;
    (void)context;
    return reader->source->size;
}

/* Called instead of printing to stderr. The context is one for reading, so asking it takes no lock.
 */
static void on_error(exr_const_context_t context, exr_result_t code, const char *message)
{
    void *user = NULL;
    (void)code;
    if (!context || exr_get_user_data(context, &user) != EXR_ERR_SUCCESS || !user)
        return;
    struct exr_reader *reader = user;
    if (reader->message[0] == '\0')
        snprintf(reader->message, sizeof reader->message, "%s", message);
}

/* --- the pixels --- */

/* Make planes for the largest chunk. */
static brdf_status make_planes(struct exr_reader *reader, int width, int height,
                               struct brdf_error *error)
{
    reader->plane_size = (size_t)width * (size_t)height;
    reader->planes = calloc(reader->plane_size, (EXR_COLOURS + 1) * sizeof *reader->planes);
    return reader->planes ? BRDF_OK : brdfcl_exr_fail(reader, EXR_ERR_OUT_OF_MEMORY, error);
}

/*
 * Where each channel is decoded to. Channels that are not wanted share the last plane: with no
 * place at all given for some, OpenEXR 3.1 picks routines that write through the missing pointer.
 */
static void point_channels(struct exr_reader *reader, int width)
{
    for (int c = 0; c < reader->pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &reader->pipeline.channels[c];
        int plane = EXR_COLOURS;
        for (int i = 0; i < EXR_COLOURS; i++)
            plane = reader->colour[i] == c ? reader->plane[i] : plane;
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = sizeof(float);
        channel->user_pixel_stride = sizeof(float);
        channel->user_line_stride = (int32_t)sizeof(float) * width;
        channel->decode_to_ptr = (uint8_t *)(reader->planes + (size_t)plane * reader->plane_size);
    }
}

void brdfcl_exr_copy(struct exr_reader *reader, int x, int y, int width, int height)
{
    struct brdfcl_image *image = reader->image;
    const long long left = (long long)reader->data.min.x + x - reader->display.min.x;
    const long long top = (long long)reader->data.min.y + y - reader->display.min.y;
    for (int row = 0; row < height; row++) {
        const long long to_y = top + row;
        if (to_y < 0 || to_y >= image->height)
            continue;
        for (int column = 0; column < width; column++) {
            const long long to_x = left + column;
            if (to_x < 0 || to_x >= image->width)
                continue;
            float *to = image->rgb + (size_t)(to_y * image->width + to_x) * 3;
            const float *from = reader->planes + (size_t)row * (size_t)width + (size_t)column;
            for (int i = 0; i < EXR_COLOURS; i++)
                to[i] = from[(size_t)reader->plane[i] * reader->plane_size];
        }
    }
}

static exr_result_t decode_chunk(struct exr_reader *reader, const exr_chunk_info_t *chunk, int x,
                                 int y)
{
    exr_decode_pipeline_t *pipeline = &reader->pipeline;
    exr_result_t code;
    if ((size_t)chunk->width * (size_t)chunk->height > reader->plane_size)
        return EXR_ERR_CORRUPT_CHUNK;
    if (reader->pipeline_ready)
        code = exr_decoding_update(reader->context, reader->part, chunk, pipeline);
    else
        code = exr_decoding_initialize(reader->context, reader->part, chunk, pipeline);
    reader->pipeline_ready = 1;
    if (code != EXR_ERR_SUCCESS)
        return code;
    point_channels(reader, chunk->width);
    code = exr_decoding_choose_default_routines(reader->context, reader->part, pipeline);
    /* What would not get smaller is stored as it is; OpenEXR 3.1 forgets so for B44. */
    if (chunk->packed_size == chunk->unpacked_size)
        pipeline->decompress_fn = NULL;
    if (code == EXR_ERR_SUCCESS)
        code = exr_decoding_run(reader->context, reader->part, pipeline);
    if (code == EXR_ERR_SUCCESS)
        brdfcl_exr_copy(reader, x, y, chunk->width, chunk->height);
    return code;
}

static brdf_status read_lines(struct exr_reader *reader, struct brdf_error *error)
{
    int32_t lines = 0;
    int width = reader->data.max.x - reader->data.min.x + 1;
    int height = reader->data.max.y - reader->data.min.y + 1;
    exr_result_t code = exr_get_scanlines_per_chunk(reader->context, reader->part, &lines);
    if (code != EXR_ERR_SUCCESS || lines < 1)
        return brdfcl_exr_fail(reader, code, error);
    brdf_status status = make_planes(reader, width, lines < height ? lines : height, error);
    if (status != BRDF_OK)
        return status;
    for (int y = 0; y < height; y += lines) {
        exr_chunk_info_t chunk;
        code = exr_read_scanline_chunk_info(reader->context, reader->part, reader->data.min.y + y,
                                            &chunk);
        if (code == EXR_ERR_SUCCESS)
            code = decode_chunk(reader, &chunk, 0, y);
        if (code != EXR_ERR_SUCCESS)
            return brdfcl_exr_fail(reader, code, error);
    }
    return BRDF_OK;
}

static brdf_status read_tiles(struct exr_reader *reader, struct brdf_error *error)
{
    int32_t tile_width = 0, tile_height = 0;
    int width = reader->data.max.x - reader->data.min.x + 1;
    int height = reader->data.max.y - reader->data.min.y + 1;
    exr_result_t code =
        exr_get_tile_sizes(reader->context, reader->part, 0, 0, &tile_width, &tile_height);
    if (code != EXR_ERR_SUCCESS || tile_width < 1 || tile_height < 1)
        return brdfcl_exr_fail(reader, code, error);
    tile_width = tile_width < width ? tile_width : width;
    tile_height = tile_height < height ? tile_height : height;
    brdf_status status = make_planes(reader, tile_width, tile_height, error);
    if (status != BRDF_OK)
        return status;
    for (int y = 0; y < height; y += tile_height)
        for (int x = 0; x < width; x += tile_width) {
            exr_chunk_info_t chunk;
            code = exr_read_tile_chunk_info(reader->context, reader->part, x / tile_width,
                                            y / tile_height, 0, 0, &chunk);
            if (code == EXR_ERR_SUCCESS)
                code = decode_chunk(reader, &chunk, x, y);
            if (code != EXR_ERR_SUCCESS)
                return brdfcl_exr_fail(reader, code, error);
        }
    return BRDF_OK;
}

static brdf_status read_pixels(struct exr_reader *reader, struct brdf_error *error)
{
    exr_storage_t storage = EXR_STORAGE_SCANLINE;
    exr_compression_t compression = EXR_COMPRESSION_NONE;
    exr_get_storage(reader->context, reader->part, &storage);
    exr_get_compression(reader->context, reader->part, &compression);
    if (compression == EXR_COMPRESSION_DWAA || compression == EXR_COMPRESSION_DWAB)
        return brdfcl_exr_read_dwa(reader, error);
    return storage == EXR_STORAGE_TILED ? read_tiles(reader, error) : read_lines(reader, error);
}

brdf_status brdfcl_image_read_exr(struct brdfcl_image *image,
                                  const struct brdfcl_image_source *source,
                                  struct brdf_error *error)
{
    struct exr_reader reader;
    memset(&reader, 0, sizeof reader);
    reader.source = source;
    reader.image = image;
    exr_context_initializer_t callbacks = EXR_DEFAULT_CONTEXT_INITIALIZER;
    callbacks.error_handler_fn = on_error;
    callbacks.user_data = &reader;
    callbacks.read_fn = on_read;
    callbacks.size_fn = on_size;
    /* An image that was not finished is damaged, rather than to be guessed at. */
    callbacks.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    exr_result_t code = exr_start_read(&reader.context, source->path, &callbacks);
    if (code != EXR_ERR_SUCCESS)
        return brdfcl_exr_fail(&reader, code, error);
    brdf_status status = brdfcl_exr_read_header(&reader, error);
    if (status == BRDF_OK)
        status = brdfcl_image_create(image, reader.display.max.x - reader.display.min.x + 1,
                                     reader.display.max.y - reader.display.min.y + 1, error);
    if (status == BRDF_OK)
        status = read_pixels(&reader, error);
    if (reader.pipeline_ready)
        exr_decoding_destroy(reader.context, &reader.pipeline);
    exr_finish(&reader.context);
    free(reader.planes);
    return status;
}
