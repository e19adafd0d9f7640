/*
 * image_png.c - see image_png.h.
 */
#include "image_png.h"

#include <stdio.h>
#include <string.h>

void brdfcl_png_error(png_structp png, png_const_charp message)
{
    struct png_job *job = png_get_error_ptr(png);
    snprintf(job->message, sizeof job->message, "%s", message);
    png_longjmp(png, 1);
}

void brdfcl_png_warning(png_structp png, png_const_charp message)
{
    struct png_job *job = png_get_error_ptr(png);
    snprintf(job->warning, sizeof job->warning, "%s", message);
}

brdf_status brdfcl_png_fail(struct png_job *job, brdf_status status, const char *what)
{
    int warned = job->warning[0] != '\0';
    if (job->status != BRDF_OK)
        return job->status;
    if (strstr(job->message, "memory"))
        status = BRDF_OUT_OF_MEMORY;
    return brdf_fail(job->error, status, "%s: %s: %s%s%s%s", job->path, what, job->message,
                     warned ? " (" : "", job->warning, warned ? ")" : "");
}
