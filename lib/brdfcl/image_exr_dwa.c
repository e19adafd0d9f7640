/*
 * image_exr_dwa.c - OpenEXR files of DWAA and DWAB compression.
 *
 * The C core of OpenEXR 3.1 cannot decode these, so that they are read with the C interface of the
 * C++ library. It knows but one pixel: red, green, blue and alpha of 16 bits. Nothing is lost by
 * it, as DWA takes the colours it compresses to 16 bits itself.
 */
#include "image_exr.h"

#include <stdint.h>
#include <stdlib.h>

#include <OpenEXR/ImfCRgbaFile.h>

/* Lines that are read at a time: those of one chunk of DWAB, which is read whole anyway. */
#define LINES 256

/* Put pixels of the library, count of them, into the planes. */
static void fill_planes(struct exr_reader *reader, const ImfRgba *pixels, size_t count)
{
    float *red = reader->planes;
    float *green = red + reader->plane_size;
    float *blue = green + reader->plane_size;
    for (size_t i = 0; i < count; i++) {
        red[i] = ImfHalfToFloat(pixels[i].r);
        green[i] = ImfHalfToFloat(pixels[i].g);
        blue[i] = ImfHalfToFloat(pixels[i].b);
    }
}

static brdf_status read_file(struct exr_reader *reader, ImfInputFile *file, ImfRgba *pixels,
                             struct brdf_error *error)
{
    const exr_attr_box2i_t *data = &reader->data;
    const int width = data->max.x - data->min.x + 1;
    for (int y = data->min.y; y <= data->max.y; y += LINES) {
        const int last = data->max.y - y < LINES ? data->max.y : y + LINES - 1;
        /*
         * The library adds x + y * width to the address of a pixel 0, 0 that is not there: wrapping
         * unsigned numbers, since such a pointer may not be computed with.
         */
        const uintptr_t before = (uintptr_t)(data->min.x + (long long)y * width) * sizeof *pixels;
        ImfRgba *origin = (ImfRgba *)((uintptr_t)pixels - before);
        if (!ImfInputSetFrameBuffer(file, origin, 1, (size_t)width) ||
            !ImfInputReadPixels(file, y, last))
            return brdf_fail(error, BRDF_BAD_FILE, "%s: not valid OpenEXR: %s",
                             reader->source->path, ImfErrorMessage());
        fill_planes(reader, pixels, (size_t)width * (size_t)(last - y + 1));
        brdfcl_exr_copy(reader, 0, y - data->min.y, width, last - y + 1);
    }
    return BRDF_OK;
}

brdf_status brdfcl_exr_read_dwa(struct exr_reader *reader, struct brdf_error *error)
{
    const size_t width = (size_t)(reader->data.max.x - reader->data.min.x + 1);
    const size_t height = (size_t)(reader->data.max.y - reader->data.min.y + 1);
    brdf_status status;
    if (reader->part != 0)
        return brdf_fail(error, BRDF_UNSUPPORTED,
                         "%s: DWA compression is only supported in the first part",
                         reader->source->path);
    reader->plane_size = width * (height < LINES ? height : LINES);
    reader->planes = calloc(reader->plane_size, EXR_COLOURS * sizeof *reader->planes);
    ImfRgba *pixels = calloc(reader->plane_size, sizeof *pixels);
    ImfInputFile *file = ImfOpenInputFile(reader->source->path);
    /* Luminance alone comes as three equal colours. */
    for (int i = 0; i < EXR_COLOURS; i++)
        reader->plane[i] = i;
    if (!reader->planes || !pixels)
        status = brdfcl_exr_fail(reader, EXR_ERR_OUT_OF_MEMORY, error);
    else if (!file)
        status = brdf_fail(error, BRDF_BAD_FILE, "%s: not valid OpenEXR: %s", reader->source->path,
                           ImfErrorMessage());
    else
        status = read_file(reader, file, pixels, error);
    if (file)
        ImfCloseInputFile(file);
    free(pixels);
    return status;
}
