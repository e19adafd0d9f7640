/*
 * image_exr_write.c - pictures into OpenEXR files (lines, ZIP), with the C core of OpenEXR.
 *
 * What OpenEXR has to say about an error is not listened to: in a context for writing, asking in
 * the error handler whose context it is would wait for a lock that the caller already holds. Names
 * and sizes are checked before, so that what remains is the disk, which on_write knows, and memory.
 */
#include "image_formats.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <OpenEXR/openexr.h>

#define COLOURS 3
#define HALF_MAX 65504.0f

struct exr_writer {
    const struct brdfcl_image *image;
    const struct brdfcl_image_options *options;
    struct brdfcl_atomic_file *file;
    struct brdf_error *error;
    exr_context_t context;
    exr_encode_pipeline_t pipeline;
    int pipeline_ready;
    exr_result_t (*write_chunk)(exr_encode_pipeline_t *); /* OpenEXR's own */
    int part;
    float *rows;        /* half only: the lines of a chunk, within the range of half */
    brdf_status status; /* of the last write: error is filled in if it is not BRDF_OK */
};

static int64_t on_write(exr_const_context_t context, void *user, const void *buffer, uint64_t size,
                        uint64_t offset, exr_stream_error_func_ptr_t report)
{
    struct exr_writer *writer = user;
    (void)context;
    (void)report;
    if (writer->status == BRDF_OK)
        writer->status = brdfcl_atomic_write(writer->file, buffer, (size_t)size, (long long)offset,
                                             writer->error);
    return writer->status == BRDF_OK ? (int64_t)size : -1;
}

static void on_error(exr_const_context_t context, exr_result_t code, const char *message)
{
    (void)context;
    (void)code;
    (void)message;
}

static brdf_status finish_status(const struct exr_writer *writer, exr_result_t code)
{
    const char *path = writer->file->path;
    if (writer->status != BRDF_OK || code == EXR_ERR_SUCCESS)
        return writer->status;
    if (code == EXR_ERR_OUT_OF_MEMORY)
        return brdf_fail(writer->error, BRDF_OUT_OF_MEMORY, "%s: out of memory while writing it",
                         path);
    return brdf_fail(writer->error, BRDF_IO, "%s: cannot be written as OpenEXR: %s", path,
                     exr_get_default_error_message(code));
}

static exr_result_t put_metadata(const struct exr_writer *writer)
{
    exr_result_t code = EXR_ERR_SUCCESS;
    for (int i = 0; code == EXR_ERR_SUCCESS && i < writer->options->metadata_count; i++) {
        const struct brdfcl_image_metadata *entry = &writer->options->metadata[i];
        if (entry->kind == BRDFCL_METADATA_TEXT)
            code =
                exr_attr_set_string(writer->context, writer->part, entry->name, entry->value.text);
        else if (entry->kind == BRDFCL_METADATA_INT)
            code =
                exr_attr_set_int(writer->context, writer->part, entry->name, entry->value.integer);
        else
            code =
                exr_attr_set_float(writer->context, writer->part, entry->name, entry->value.number);
    }
    return code;
}

static exr_result_t put_header(struct exr_writer *writer)
{
    static const exr_attr_chromaticities_t rec709 = {0.64f, 0.33f, 0.30f,   0.60f,
                                                     0.15f, 0.06f, 0.3127f, 0.3290f};
    static const char *const names[COLOURS] = {"B", "G", "R"};
    const exr_pixel_type_t type = writer->options->half ? EXR_PIXEL_HALF : EXR_PIXEL_FLOAT;
    exr_result_t code = exr_add_part(writer->context, "image", EXR_STORAGE_SCANLINE, &writer->part);
    if (code == EXR_ERR_SUCCESS)
        code =
            exr_initialize_required_attr_simple(writer->context, writer->part, writer->image->width,
                                                writer->image->height, EXR_COMPRESSION_ZIP);
    for (int i = 0; code == EXR_ERR_SUCCESS && i < COLOURS; i++)
        code = exr_add_channel(writer->context, writer->part, names[i], type,
                               EXR_PERCEPTUALLY_LOGARITHMIC, 1, 1);
    if (code == EXR_ERR_SUCCESS)
        code =
            exr_attr_set_chromaticities(writer->context, writer->part, "chromaticities", &rec709);
    if (code == EXR_ERR_SUCCESS)
        code = put_metadata(writer);
    return code == EXR_ERR_SUCCESS ? exr_write_header(writer->context) : code;
}

/* The lines that a chunk is encoded from: those of the image, or a copy that half can hold. */
static const float *chunk_rows(struct exr_writer *writer, const exr_chunk_info_t *chunk)
{
    size_t row = (size_t)writer->image->width * 3;
    const float *from = writer->image->rgb + (size_t)chunk->start_y * row;
    if (!writer->options->half)
        return from;
    for (size_t i = 0; i < row * (size_t)chunk->height; i++) {
        float value = from[i];
        if (isfinite(value) && fabsf(value) > HALF_MAX)
            value = value > 0.0f ? HALF_MAX : -HALF_MAX;
        writer->rows[i] = value;
    }
    return writer->rows;
}

/*
 * OpenEXR 3.1 stores a chunk that does not get smaller as it is, and so readers take what is as
 * large as the pixels for the pixels; but if the compressed chunk is exactly that large, it stores
 * that.
 */
static exr_result_t write_chunk(exr_encode_pipeline_t *pipeline)
{
    const struct exr_writer *writer = pipeline->encoding_user_data;
    if (pipeline->compressed_bytes == pipeline->packed_bytes &&
        pipeline->compressed_buffer != pipeline->packed_buffer)
        memcpy(pipeline->compressed_buffer, pipeline->packed_buffer, pipeline->packed_bytes);
    return writer->write_chunk(pipeline);
}

static exr_result_t put_chunk(struct exr_writer *writer, const exr_chunk_info_t *chunk)
{
    exr_encode_pipeline_t *pipeline = &writer->pipeline;
    exr_result_t code;
    if (writer->pipeline_ready)
        code = exr_encoding_update(writer->context, writer->part, chunk, pipeline);
    else
        code = exr_encoding_initialize(writer->context, writer->part, chunk, pipeline);
    writer->pipeline_ready = 1;
    if (code != EXR_ERR_SUCCESS)
        return code;
    const float *rows = chunk_rows(writer, chunk);
    for (int c = 0; c < pipeline->channel_count; c++) { /* sorted by name: B, G, R */
        exr_coding_channel_info_t *channel = &pipeline->channels[c];
        channel->user_data_type = EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = sizeof(float);
        channel->user_pixel_stride = 3 * (int32_t)sizeof(float);
        channel->user_line_stride = writer->image->width * 3 * (int32_t)sizeof(float);
        channel->encode_from_ptr = (const uint8_t *)(rows + (COLOURS - 1 - c));
    }
    code = exr_encoding_choose_default_routines(writer->context, writer->part, pipeline);
    if (code != EXR_ERR_SUCCESS)
        return code;
    writer->write_chunk = pipeline->write_fn;
    pipeline->write_fn = write_chunk;
    pipeline->encoding_user_data = writer;
    return exr_encoding_run(writer->context, writer->part, pipeline);
}

static exr_result_t put_pixels(struct exr_writer *writer)
{
    int32_t lines = 0;
    exr_result_t code = exr_get_scanlines_per_chunk(writer->context, writer->part, &lines);
    if (code == EXR_ERR_SUCCESS && writer->options->half) {
        writer->rows =
            calloc((size_t)writer->image->width * (size_t)lines, 3 * sizeof *writer->rows);
        if (!writer->rows)
            code = EXR_ERR_OUT_OF_MEMORY;
    }
    for (int y = 0; code == EXR_ERR_SUCCESS && y < writer->image->height; y += lines) {
        exr_chunk_info_t chunk;
        code = exr_write_scanline_chunk_info(writer->context, writer->part, y, &chunk);
        if (code == EXR_ERR_SUCCESS)
            code = put_chunk(writer, &chunk);
    }
    return code;
}

brdf_status brdfcl_image_write_exr(const struct brdfcl_image *image,
                                   const struct brdfcl_image_options *options,
                                   struct brdfcl_atomic_file *file, struct brdf_error *error)
{
    struct exr_writer writer;
    memset(&writer, 0, sizeof writer);
    writer.image = image;
    writer.options = options;
    writer.file = file;
    writer.error = error;
    exr_context_initializer_t callbacks = EXR_DEFAULT_CONTEXT_INITIALIZER;
    callbacks.error_handler_fn = on_error;
    callbacks.user_data = &writer;
    callbacks.write_fn = on_write;
    /* The name is only kept for messages: on_write writes. */
    exr_result_t code =
        exr_start_write(&writer.context, file->path, EXR_WRITE_FILE_DIRECTLY, &callbacks);
    if (code != EXR_ERR_SUCCESS)
        return finish_status(&writer, code);
    code = put_header(&writer);
    if (code == EXR_ERR_SUCCESS)
        code = put_pixels(&writer);
    if (writer.pipeline_ready)
        exr_encoding_destroy(writer.context, &writer.pipeline);
    exr_result_t finished = exr_finish(&writer.context);
    free(writer.rows);
    return finish_status(&writer, code == EXR_ERR_SUCCESS ? finished : code);
}
