/* complete.c - unmeasured bins above the surface. */
#include "complete.h"

#include <stdlib.h>
#include <string.h>

#include "bins.h"
#include "open.h"

static int bin_is_above(const struct brdf_merl_file *file, size_t bin)
{
    double wo[3], wi[3];
    return lab_bin_directions(lab_bin_of(file, bin), wo, wi);
}

brdf_status lab_complete_merl(struct brdf_merl_file *file, int fill, struct brdf_error *error)
{
    struct brdf_merl_file filled = *file;
    size_t size = file->bins * 3 * sizeof *file->rgb;
    filled.rgb = malloc(size);
    if (!filled.rgb) {
        return brdf_fail(error, BRDF_OUT_OF_MEMORY, "no memory to fill %zu bins", file->bins);
    }
    memcpy(filled.rgb, file->rgb, size);
    brdf_status status = brdf_merl_fill(&filled, error);
    for (size_t bin = 0; bin < file->bins && status == BRDF_OK; ++bin) {
        if (file->rgb[3 * bin] < 0.0f && bin_is_above(file, bin)) {
            for (size_t c = 0; c < 3; ++c) {
                file->rgb[3 * bin + c] = fill ? filled.rgb[3 * bin + c] : 0.0f;
            }
            --file->invalid;
        }
    }
    free(filled.rgb);
    return status;
}

brdf_status lab_complete_open(const char *text, struct brdf_merl_file *file,
                              struct brdf_error *error)
{
    enum lab_format format;
    brdf_status status = lab_open_merl(text, file, &format, error);
    if (status == BRDF_OK) {
        status = lab_complete_merl(file, 1, error);
    }
    if (status) {
        brdf_merl_free(file);
    }
    return status;
}
