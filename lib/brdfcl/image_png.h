/*
 * image_png.h - what reading and writing PNG share: libpng's errors made ours.
 *
 * libpng reports errors by longjmp. Each direction keeps all its state in a struct that lives in
 * the caller of the function with the setjmp, so that nothing depends on local variables whose
 * values a longjmp leaves undefined.
 */
#ifndef BRDFCL_IMAGE_PNG_H
#define BRDFCL_IMAGE_PNG_H

#include <png.h>

#include "image_formats.h"

/* What libpng's pointer for errors points to: a part of either direction's own state. */
struct png_job {
    png_structp png;
    png_infop info;
    const char *path;
    char message[256]; /* of libpng */
    char warning[256]; /* the last one; often says more than the error after it */
    brdf_status status;
    struct brdf_error *error;
    long long offset; /* in the file */
};

/* For png_create_read_struct and png_create_write_struct. */
void brdfcl_png_error(png_structp png, png_const_charp message);
void brdfcl_png_warning(png_structp png, png_const_charp message);

/* After a longjmp: an error that is already told about stays, else it is what libpng said. */
brdf_status brdfcl_png_fail(struct png_job *job, brdf_status status, const char *what);

#endif
