/*
 * rgl_views.c - the distribution of normals that explains what a function reflects from all
 * directions, not only straight back.
 *
 * Dupuy and Jakob 2018 find D from retro-reflection, which can be measured first; it then places
 * all other measurements. A narrow lobe of a dielectric over a matte base is faint there next to
 * the base, while near grazing it reflects most: the warp would leave it a handful of nodes. A
 * function can be asked everywhere, so D is the mean of what retro-reflection and each of the views
 * show. It stays one D for all views; warps that followed each view's own lobe would not fit
 * together where values are interpolated between views (they were tried: albedos came out wrong by
 * factors).
 */
#include "angle.h"
#include "rgl_making.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "rgl_normals.h"

enum {
    RING = 32, /* azimuths of a normal, over which an isotropic distribution is averaged */
    TURN = 8   /* azimuths of wo, where it is not isotropic */
};

/* 4 f cos(theta_i), mean of the channels, where a normal reflects wo to; 0 below the surface. */
static brdf_status normal_ask(struct brdf_rgl_making *m, const double wo[3], const double normal[3],
                              double *d)
{
    double wi[3], seen = wo[0] * normal[0] + wo[1] * normal[1] + wo[2] * normal[2];
    *d = 0.0;
    for (int i = 0; i < 3; ++i) {
        wi[i] = 2.0 * seen * normal[i] - wo[i];
    }
    if (seen <= 0.0 || wi[2] <= 0.0) {
        return BRDF_OK;
    }
    brdf_status status = brdf_rgl_ask(m, wo, wi);
    for (int i = 0; i < m->grid.channels && !status; ++i) {
        *d += 4.0 * fmax(m->values[i], 0.0) * wi[2] / m->grid.channels;
    }
    return status;
}

/* What a view shows of the distribution, up to a factor, at every node. */
static brdf_status view_find(struct brdf_rgl_making *m, const struct brdf_rgl_normals *n,
                             const double wo[3], double *d)
{
    int rows = n->isotropic ? RING + 1 : n->rows;
    brdf_status status = BRDF_OK;
    memset(d, 0, (size_t)(n->rows * n->columns) * sizeof *d);
    for (int k = 0; k < rows * n->columns && !status; ++k) {
        int row = k / n->columns, column = k % n->columns;
        double normal[3], value;
        brdf_rgl_direction(row, rows, column, n->columns, normal);
        status = normal_ask(m, wo, normal, &value);
        if (n->isotropic) {
            d[column] += (row == 0 || row == RING ? 0.5 : 1.0) / RING * value;
            d[column + n->columns] = d[column];
        } else {
            d[k] = value;
        }
    }
    return status;
}

/* Add what views of this polar angle show, each with an area of 1 as d; *added counts them. */
static brdf_status views_add(struct brdf_rgl_making *m, const struct brdf_rgl_normals *n,
                             double theta, double *d, double *sum, int *added)
{
    int azimuths = n->isotropic || theta <= 0.0 ? 1 : TURN;
    brdf_status status = BRDF_OK;
    for (int i = 0; i < azimuths && !status; ++i) {
        double phi = 2.0 * pi * i / azimuths;
        const double wo[3] = {sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)};
        status = view_find(m, n, wo, d);
        double area = status ? 0.0 : brdf_rgl_normals_area(n, d);
        for (int k = 0; k < n->rows * n->columns && area > 0.0; ++k) {
            sum[k] += d[k] / area / azimuths;
        }
        *added += i == 0 && area > 0.0;
    }
    return status;
}

brdf_status brdf_rgl_views_blend(struct brdf_rgl_making *m, struct brdf_rgl_normals *n)
{
    const struct brdf_rgl_file *file = m->file;
    size_t count = (size_t)n->rows * (size_t)n->columns;
    double *d = malloc(2 * count * sizeof *d);
    int added = 1;
    brdf_status status = BRDF_OK;
    if (!d) {
        return brdf_fail(m->error, BRDF_OUT_OF_MEMORY, "no memory for %zu normals", count);
    }
    memcpy(d + count, n->d, count * sizeof *d);
    for (int i = 0; i + 1 < file->theta_count && !status; ++i) { /* the last is grazing */
        status = views_add(m, n, (double)file->theta_i[i], d, d + count, &added);
    }
    for (size_t k = 0; k < count && !status; ++k) {
        n->d[k] = d[count + k] / added;
    }
    free(d);
    return status;
}
