/*
 * image_formats.h - what image.c asks of each file format.
 *
 * A reader gets an open file and an empty image. It checks the size that the header claims with
 * brdfcl_image_size_check before it allocates anything of that size, and on failure leaves whatever
 * it has put into the image for image.c to free.
 */
#ifndef BRDFCL_IMAGE_FORMATS_H
#define BRDFCL_IMAGE_FORMATS_H

#include <brdfcl/image.h>

#include "atomic_file.h"

struct brdfcl_image_source {
    int fd;           /* open for reading; regular, so that pread() works */
    long long size;   /* bytes */
    const char *path; /* for messages */
    int raw;          /* PNG: do not undo the sRGB curve, make 0 .. 1 of the numbers as they are */
    int *bits;        /* PNG: gets the bits of a channel, 8 or 16; may be NULL */
};

/*
 * As brdfcl_image_read, for a picture that is numbers and not light: `raw` as above. *bits are
 * those of a PNG's channel, 8 or 16, and 0 of OpenEXR. If they are 8, every float is one of
 * brdfcl_image_codes.
 */
brdf_status brdfcl_image_read_numbers(struct brdfcl_image *image, const char *path, int raw,
                                      int *bits, struct brdf_error *error);

/* What the 256 numbers of 8 bits are as floats. */
void brdfcl_image_codes(int raw, float table[256]);

/* Refuse a size beyond the limits of image.h, or of nothing. */
brdf_status brdfcl_image_size_check(const char *path, long long width, long long height,
                                    struct brdf_error *error);

/*
 * Read up to size bytes at an offset, fewer only at the end of the file. Returns how many, or -1
 * with errno set.
 */
long long brdfcl_image_source_read(const struct brdfcl_image_source *source, void *data,
                                   size_t size, long long offset);

brdf_status brdfcl_image_read_exr(struct brdfcl_image *image,
                                  const struct brdfcl_image_source *source,
                                  struct brdf_error *error);
brdf_status brdfcl_image_read_png(struct brdfcl_image *image,
                                  const struct brdfcl_image_source *source,
                                  struct brdf_error *error);

/* Writers find image and options checked, and options never NULL; file is left open. */
brdf_status brdfcl_image_write_exr(const struct brdfcl_image *image,
                                   const struct brdfcl_image_options *options,
                                   struct brdfcl_atomic_file *file, struct brdf_error *error);
brdf_status brdfcl_image_write_png(const struct brdfcl_image *image,
                                   const struct brdfcl_image_options *options,
                                   struct brdfcl_atomic_file *file, struct brdf_error *error);

#endif
