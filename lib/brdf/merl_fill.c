/*
 * merl_fill.c - bins without a measurement, filled from those that have one.
 *
 * Invalid bins are mostly those at grazing angles, where one direction dips below the surface.
 * Nothing asks for their own value, but interpolation reaches into them from the last valid ones,
 * so a zero would darken the horizon. Each column of constant (theta_d, phi_d) is completed along
 * theta_h: between two valid bins linearly, beyond the last valid one constantly. A column without
 * any valid bin then copies the one of the nearest smaller theta_d (same phi_d), or else of the
 * nearest larger, or else that of the nearest phi_d.
 */
#include "merl_format.h"

#include <string.h>

/* The bins of one column are this far apart, in floats. */
static size_t column_stride(const struct brdf_merl_file *file)
{
    return 3 * (size_t)file->theta_d * (size_t)file->phi_d;
}

static float *column_at(const struct brdf_merl_file *file, int theta_d, int phi_d)
{
    return file->rgb + 3 * ((size_t)theta_d * (size_t)file->phi_d + (size_t)phi_d);
}

/* Bins from `low` to `high`, exclusive, between those two; either may not exist (-1, count). */
static void gap_fill(float *column, size_t stride, int low, int high, int count)
{
    const float *a = column + stride * (size_t)(low >= 0 ? low : high);
    const float *b = column + stride * (size_t)(high < count ? high : low);
    for (int k = low + 1; k < high; ++k) {
        float t = (float)(k - low) / (float)(high - low);
        float *f = column + stride * (size_t)k;
        for (int c = 0; c < 3; ++c) {
            f[c] = a[c] + t * (b[c] - a[c]);
        }
    }
}

/* Complete one column, unless it has no valid bin at all. */
static void column_fill(float *column, size_t stride, int count)
{
    int last = -1;
    for (int k = 0; k < count; ++k) {
        if (column[stride * (size_t)k] >= 0.0f) {
            gap_fill(column, stride, last, k, count);
            last = k;
        }
    }
    if (last >= 0) {
        gap_fill(column, stride, last, count, count);
    }
}

static void column_copy(const struct brdf_merl_file *file, float *to, const float *from)
{
    size_t stride = column_stride(file);
    for (size_t k = 0; k < (size_t)file->theta_h; ++k) {
        memcpy(to + stride * k, from + stride * k, 3 * sizeof(float));
    }
}

/* Columns of one phi_d that are still empty take the nearest complete one; 0 if there is none. */
static int plane_fill(const struct brdf_merl_file *file, int phi_d)
{
    int first = -1;
    for (int d = 0; d < file->theta_d; ++d) {
        float *column = column_at(file, d, phi_d);
        if (column[0] >= 0.0f && first < 0) {
            first = d;
        } else if (column[0] < 0.0f && first >= 0) {
            column_copy(file, column, column_at(file, d - 1, phi_d));
        }
    }
    for (int d = 0; d < first; ++d) {
        column_copy(file, column_at(file, d, phi_d), column_at(file, first, phi_d));
    }
    return first >= 0;
}

/* The nearest phi_d, around the half turn, whose plane has values. */
static int plane_nearest(const unsigned char *filled, int count, int phi_d)
{
    for (int away = 1; away < count; ++away) {
        for (int side = -1; side <= 1; side += 2) {
            int other = (phi_d + side * away + count) % count;
            if (filled[other]) {
                return other;
            }
        }
    }
    return phi_d;
}

static void values_fill(struct brdf_merl_file *file)
{
    size_t stride = column_stride(file);
    unsigned char filled[BRDF_MERL_FILE_PHI_D];
    for (int d = 0; d < file->theta_d; ++d) {
        for (int p = 0; p < file->phi_d; ++p) {
            column_fill(column_at(file, d, p), stride, file->theta_h);
        }
    }
    for (int p = 0; p < file->phi_d; ++p) {
        filled[p] = (unsigned char)plane_fill(file, p);
    }
    for (int p = 0; p < file->phi_d; ++p) {
        int from = filled[p] ? p : plane_nearest(filled, file->phi_d, p);
        for (int d = 0; from != p && d < file->theta_d; ++d) {
            column_copy(file, column_at(file, d, p), column_at(file, d, from));
        }
    }
}

void brdf_merl_replace(struct brdf_merl_file *file, enum brdf_merl_invalid invalid)
{
    if (invalid == BRDF_MERL_INVALID_FILL && file->invalid > 0) {
        values_fill(file);
    } else if (invalid == BRDF_MERL_INVALID_ZERO && file->invalid > 0) {
        for (size_t i = 0; i < file->bins * 3; ++i) {
            file->rgb[i] = file->rgb[i] < 0.0f ? 0.0f : file->rgb[i];
        }
    }
}

brdf_status brdf_merl_fill(struct brdf_merl_file *file, struct brdf_error *error)
{
    if (!file || !file->rgb || file->invalid >= file->bins) {
        return brdf_fail(error, BRDF_BAD_ARGUMENT,
                         "brdf_merl_fill needs a table with at least one valid bin");
    }
    brdf_merl_replace(file, BRDF_MERL_INVALID_FILL);
    return BRDF_OK;
}
