/*
 * image_samples.h - image files of every kind for the tests, made with OpenEXR and libpng directly.
 *
 * Samples are a function of channel and position, so that a test knows what it must read back.
 */
#ifndef IMAGE_SAMPLES_H
#define IMAGE_SAMPLES_H

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <OpenEXR/openexr.h>
#include <OpenEXR/ImfCRgbaFile.h>
#include <png.h>

#include "support_place.h"

/* The place of a test program's files: its setup and teardown. */
static struct place place;

static inline int make_folder(void **state)
{
    (void)state;
    return place_make(&place, "a picture of no suffix");
}

static inline int remove_folder(void **state)
{
    (void)state;
    return place_remove(&place);
}

#define SAMPLE_CHANNELS 8

/* Exactly half, float and (for whole numbers) uint: channel 0 counts pixels, the others add to it.
 */
static inline float sample_value(int channel, int x, int y)
{
    return (float)(channel * 256 + y * 16 + x);
}

struct exr_sample {
    const char *channels[SAMPLE_CHANNELS]; /* in alphabetical order, ended by NULL */
    exr_pixel_type_t type;
    exr_compression_t compression;
    exr_attr_box2i_t data, display; /* data at most 16 x 16, at coordinates of 0..15 */
    int tile;                       /* side of a tile, or 0 for lines */
    int sampling;                   /* of the last channel; 0 is 1 */
    const exr_attr_chromaticities_t *primaries;
    int deep;
};

/* Three channels in lines, with the corner at 0, 0. */
static inline struct exr_sample sample_plain(exr_pixel_type_t type, int width, int height)
{
    struct exr_sample sample;
    memset(&sample, 0, sizeof sample);
    sample.channels[0] = "B";
    sample.channels[1] = "G";
    sample.channels[2] = "R";
    sample.type = type;
    sample.compression = EXR_COMPRESSION_ZIP;
    sample.data.max.x = width - 1;
    sample.data.max.y = height - 1;
    sample.display = sample.data;
    return sample;
}

static inline void sample_silent(exr_const_context_t context, exr_result_t code, const char *text)
{
    (void)context;
    (void)code;
    (void)text;
}

/* Through a stream of ours, since OpenEXR removes a file that is left unfinished. */
static inline int64_t sample_put(exr_const_context_t context, void *user, const void *bytes,
                                 uint64_t size, uint64_t offset, exr_stream_error_func_ptr_t report)
{
    (void)context;
    (void)report;
    if (fseek(user, (long)offset, SEEK_SET) != 0)
        return -1;
    return (int64_t)fwrite(bytes, 1, (size_t)size, user);
}

static inline void exr_sample_header(exr_context_t file, const struct exr_sample *sample)
{
    exr_attr_v2f_t center = {{{0.0f, 0.0f}}};
    int part;
    exr_storage_t storage = sample->tile ? EXR_STORAGE_TILED : EXR_STORAGE_SCANLINE;
    if (sample->deep)
        storage = EXR_STORAGE_DEEP_SCANLINE;
    assert_int_equal(exr_add_part(file, "sample", storage, &part), 0);
    assert_int_equal(exr_initialize_required_attr(file, part, &sample->display, &sample->data, 1.0f,
                                                  &center, 1.0f, EXR_LINEORDER_INCREASING_Y,
                                                  sample->compression),
                     0);
    if (sample->tile)
        assert_int_equal(exr_set_tile_descriptor(file, part, (uint32_t)sample->tile,
                                                 (uint32_t)sample->tile, EXR_TILE_ONE_LEVEL,
                                                 EXR_TILE_ROUND_DOWN),
                         0);
    for (int c = 0; sample->channels[c]; c++) {
        int sampling = sample->sampling && !sample->channels[c + 1] ? sample->sampling : 1;
        assert_int_equal(exr_add_channel(file, part, sample->channels[c], sample->type,
                                         EXR_PERCEPTUALLY_LOGARITHMIC, sampling, sampling),
                         0);
    }
    if (sample->primaries)
        assert_int_equal(
            exr_attr_set_chromaticities(file, part, "chromaticities", sample->primaries), 0);
    if (sample->deep) {
        assert_int_equal(exr_set_version(file, part, 1), 0);
        assert_int_equal(exr_set_chunk_count(file, part, 1), 0);
    }
    assert_int_equal(exr_write_header(file), 0);
}

static exr_result_t (*sample_write)(exr_encode_pipeline_t *);

/* What does not get smaller is stored as it is, which OpenEXR 3.1 does not always do as it should.
 */
static inline exr_result_t sample_write_chunk(exr_encode_pipeline_t *pipeline)
{
    if (pipeline->compressed_bytes >= pipeline->packed_bytes &&
        pipeline->compressed_buffer != pipeline->packed_buffer) {
        memcpy(pipeline->compressed_buffer, pipeline->packed_buffer, pipeline->packed_bytes);
        pipeline->compressed_bytes = pipeline->packed_bytes;
    }
    return sample_write(pipeline);
}

/* Encode one chunk whose first pixel has these coordinates. */
static inline void exr_sample_chunk(exr_context_t file, const exr_chunk_info_t *chunk, int x0,
                                    int y0)
{
    static float floats[SAMPLE_CHANNELS][256];
    static uint32_t uints[SAMPLE_CHANNELS][256];
    exr_encode_pipeline_t pipeline = EXR_ENCODE_PIPELINE_INITIALIZER;
    assert_int_equal(exr_encoding_initialize(file, 0, chunk, &pipeline), 0);
    for (int c = 0; c < pipeline.channel_count; c++) {
        exr_coding_channel_info_t *channel = &pipeline.channels[c];
        int is_uint = channel->data_type == EXR_PIXEL_UINT;
        for (int i = 0; i < chunk->width * chunk->height; i++) {
            floats[c][i] = sample_value(c, x0 + i % chunk->width, y0 + i / chunk->width);
            uints[c][i] = (uint32_t)floats[c][i];
        }
        channel->user_data_type = is_uint ? EXR_PIXEL_UINT : EXR_PIXEL_FLOAT;
        channel->user_bytes_per_element = 4;
        channel->user_pixel_stride = 4;
        channel->user_line_stride = 4 * chunk->width;
        channel->encode_from_ptr = is_uint ? (const uint8_t *)uints[c] : (const uint8_t *)floats[c];
    }
    assert_int_equal(exr_encoding_choose_default_routines(file, 0, &pipeline), 0);
    sample_write = pipeline.write_fn;
    pipeline.write_fn = sample_write_chunk;
    assert_int_equal(exr_encoding_run(file, 0, &pipeline), 0);
    assert_int_equal(exr_encoding_destroy(file, &pipeline), 0);
}

static inline void exr_sample_write(const char *path, const struct exr_sample *sample)
{
    exr_context_t file;
    exr_chunk_info_t chunk;
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    int32_t lines = 1;
    const exr_attr_box2i_t *data = &sample->data;
    FILE *stream = fopen(path, "wb");
    assert_non_null(stream);
    options.error_handler_fn = sample_silent;
    options.user_data = stream;
    options.write_fn = sample_put;
    assert_int_equal(exr_start_write(&file, path, EXR_WRITE_FILE_DIRECTLY, &options), 0);
    exr_sample_header(file, sample);
    if (sample->deep || sample->sampling > 1) {
        exr_finish(&file); /* the header is all that must be read */
        assert_int_equal(fclose(stream), 0);
        return;
    }
    if (sample->tile)
        lines = sample->tile;
    else
        assert_int_equal(exr_get_scanlines_per_chunk(file, 0, &lines), 0);
    for (int y = data->min.y; y <= data->max.y; y += lines) {
        if (!sample->tile) {
            assert_int_equal(exr_write_scanline_chunk_info(file, 0, y, &chunk), 0);
            exr_sample_chunk(file, &chunk, data->min.x, y);
        }
        for (int x = data->min.x; sample->tile && x <= data->max.x; x += sample->tile) {
            assert_int_equal(exr_write_tile_chunk_info(file, 0, (x - data->min.x) / sample->tile,
                                                       (y - data->min.y) / sample->tile, 0, 0,
                                                       &chunk),
                             0);
            exr_sample_chunk(file, &chunk, x, y);
        }
    }
    assert_int_equal(exr_finish(&file), 0);
    assert_int_equal(fclose(stream), 0);
}

/*
 * The C core of OpenEXR cannot write DWA: through the C++ library, with channels R, G, B or Y of
 * half, all of them sample_value of channel 0.
 */
static inline void dwa_sample_write(const char *path, const struct exr_sample *sample)
{
    static ImfRgba pixels[16][16];
    const exr_attr_box2i_t *data = &sample->data, *display = &sample->display;
    const int channels = sample->channels[0][0] == 'Y' ? IMF_WRITE_Y : IMF_WRITE_RGB;
    ImfHeader *header = ImfNewHeader();
    for (int y = 0; y < 16; y++)
        for (int x = 0; x < 16; x++) {
            ImfFloatToHalf(sample_value(0, x, y), &pixels[y][x].r);
            pixels[y][x].g = pixels[y][x].b = pixels[y][x].r;
        }
    ImfHeaderSetDataWindow(header, data->min.x, data->min.y, data->max.x, data->max.y);
    ImfHeaderSetDisplayWindow(header, display->min.x, display->min.y, display->max.x,
                              display->max.y);
    ImfHeaderSetCompression(header, (int)sample->compression);
    if (sample->tile) {
        ImfTiledOutputFile *file = ImfOpenTiledOutputFile(path, header, channels, sample->tile,
                                                          sample->tile, IMF_ONE_LEVEL, 0);
        const int columns = (data->max.x - data->min.x) / sample->tile;
        const int rows = (data->max.y - data->min.y) / sample->tile;
        assert_non_null(file);
        assert_true(ImfTiledOutputSetFrameBuffer(file, &pixels[0][0], 1, 16));
        assert_true(ImfTiledOutputWriteTiles(file, 0, columns, 0, rows, 0, 0));
        assert_true(ImfCloseTiledOutputFile(file));
    } else {
        ImfOutputFile *file = ImfOpenOutputFile(path, header, channels);
        assert_non_null(file);
        assert_true(ImfOutputSetFrameBuffer(file, &pixels[0][0], 1, 16));
        assert_true(ImfOutputWritePixels(file, data->max.y - data->min.y + 1));
        assert_true(ImfCloseOutputFile(file));
    }
    ImfDeleteHeader(header);
}

/* A PNG of bytes that are already packed as its colour type and depth want them. */
static inline void png_sample_write(const char *path, int width, int height, int colour, int depth,
                                    int interlace, const unsigned char *bytes, size_t stride)
{
    static const png_color palette[4] = {{255, 0, 0}, {0, 255, 0}, {0, 0, 255}, {188, 118, 1}};
    png_byte transparent[1] = {0};
    FILE *file = fopen(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    assert_non_null(file);
    if (setjmp(png_jmpbuf(png)))
        fail_msg("libpng cannot write %s", path);
    png_init_io(png, file);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, depth, colour, interlace, 0,
                 0);
    if (colour == PNG_COLOR_TYPE_PALETTE) {
        png_set_PLTE(png, info, palette, 4);
        png_set_tRNS(png, info, transparent, 1, NULL);
    }
    png_write_info(png, info);
    for (int pass = 0; pass < (interlace ? png_set_interlace_handling(png) : 1); pass++)
        for (int y = 0; y < height; y++)
            png_write_row(png, bytes + (size_t)y * stride);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    assert_int_equal(fclose(file), 0);
}

#endif
