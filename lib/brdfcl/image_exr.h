/*
 * image_exr.h - an OpenEXR file while it is being read.
 */
#ifndef BRDFCL_IMAGE_EXR_H
#define BRDFCL_IMAGE_EXR_H

#include <OpenEXR/openexr.h>

#include "image_formats.h"

#define EXR_COLOURS 3

struct exr_reader {
    const struct brdfcl_image_source *source;
    struct brdfcl_image *image;
    exr_context_t context;
    exr_decode_pipeline_t pipeline;
    int pipeline_ready;
    int part;
    exr_attr_box2i_t data, display; /* windows: pixels stored, pixels shown; both ends included */
    const exr_attr_chlist_t *channels;
    int colour[EXR_COLOURS]; /* for red, green, blue: the channel; all the same if there is only Y
                              */
    int plane[EXR_COLOURS];  /* the plane that each colour is decoded to */
    float *planes;           /* one for each colour, and one for whatever else is in the file */
    size_t plane_size;       /* floats in each */
    char message[512];       /* the first that OpenEXR said: later ones only say that it gave up */
    int read_errno;          /* of a read that failed, or 0 */
};

/* The error for a code of OpenEXR, with what it said about it. */
brdf_status brdfcl_exr_fail(const struct exr_reader *reader, exr_result_t code,
                            struct brdf_error *error);

/*
 * Choose the part, and fill in part, data, display, channels, colour and plane. Windows are within
 * the limits of image.h then, every channel is of one value a pixel, and the pixels are Rec. 709.
 */
brdf_status brdfcl_exr_read_header(struct exr_reader *reader, struct brdf_error *error);

/*
 * Copy a block of the planes, whose lines are as long as the block is wide, to where it is in the
 * picture, as far as it is to be seen. x and y count from the corner of the data window.
 */
void brdfcl_exr_copy(struct exr_reader *reader, int x, int y, int width, int height);

/* Read the pixels of a file of DWAA or DWAB compression whose header is read. */
brdf_status brdfcl_exr_read_dwa(struct exr_reader *reader, struct brdf_error *error);

#endif
