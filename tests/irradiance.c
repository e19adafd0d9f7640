/*
 * irradiance.c - see irradiance.h.
 */
#include "irradiance.h"
#include "angle.h"

#include <math.h>

static double dot(struct point a, struct point b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

double polygon_irradiance(const struct point *corner, size_t count)
{
    double sum = 0.0;
    for (size_t i = 0; i < count; ++i) {
        struct point a = corner[i];
        struct point b = corner[(i + 1) % count];
        struct point across = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
        double length = sqrt(dot(across, across));
        sum += 0.5 * atan2(length, dot(a, b)) * across.y / length;
    }
    return fabs(sum);
}

double disk_irradiance(struct point centre, struct point a, struct point b)
{
    enum { CORNERS = 4096 };
    struct point corner[CORNERS];
    for (int i = 0; i < CORNERS; ++i) {
        double c = cos(2.0 * pi * i / CORNERS);
        double s = sin(2.0 * pi * i / CORNERS);
        corner[i].x = centre.x + c * a.x + s * b.x;
        corner[i].y = centre.y + c * a.y + s * b.y;
        corner[i].z = centre.z + c * a.z + s * b.z;
    }
    return polygon_irradiance(corner, CORNERS);
}

double sphere_irradiance(struct point centre, double radius)
{
    double distance2 = dot(centre, centre);
    return pi * radius * radius / distance2 * centre.y / sqrt(distance2);
}

double rectangle_irradiance(double half_x, double half_z, struct point centre)
{
    const struct point corner[4] = {{centre.x - half_x, centre.y, centre.z - half_z},
                                    {centre.x + half_x, centre.y, centre.z - half_z},
                                    {centre.x + half_x, centre.y, centre.z + half_z},
                                    {centre.x - half_x, centre.y, centre.z + half_z}};
    return polygon_irradiance(corner, 4);
}

/* Radiance of a map as docs/scenes.md says: columns centred at half integers, rows 0 and
   height - 1 on the poles, bilinear in between. */
static double map_at(const struct brdfcl_image *map, struct point d)
{
    double x = atan2(d.x, -d.z) / (2.0 * pi) * MAP_WIDTH - 0.5;
    double y = acos(fmax(-1.0, fmin(1.0, d.y))) / pi * (MAP_HEIGHT - 1);
    int column = (int)floor(x);
    int row = (int)fmin(floor(y), MAP_HEIGHT - 2);
    double sum = 0.0;
    for (int j = 0; j < 2; ++j) {
        for (int i = 0; i < 2; ++i) {
            int wrapped = (column + i + 2 * MAP_WIDTH) % MAP_WIDTH;
            double weight = (i ? x - column : 1.0 - x + column) * (j ? y - row : 1.0 - y + row);
            sum += weight * (double)map->rgb[3 * ((row + j) * MAP_WIDTH + wrapped)];
        }
    }
    return sum;
}

/* v turned by an angle about (0.48, 0.6, 0.64) [Rodrigues 1840]. */
static struct point turned(struct point v, double degrees)
{
    const struct point axis = {0.48, 0.6, 0.64};
    double c = cos(degrees * pi / 180.0);
    double s = sin(degrees * pi / 180.0);
    double along = dot(axis, v) * (1.0 - c);
    struct point out = {c * v.x + s * (axis.y * v.z - axis.z * v.y) + along * axis.x,
                        c * v.y + s * (axis.z * v.x - axis.x * v.z) + along * axis.y,
                        c * v.z + s * (axis.x * v.y - axis.y * v.x) + along * axis.z};
    return out;
}

double map_irradiance(const struct brdfcl_image *map, double degrees)
{
    enum { STEPS = 600 };
    double sum = 0.0;
    for (int j = 0; j < STEPS; ++j) {
        double cos2 = (j + 0.5) / STEPS; /* uniform in cos^2: each counts the same */
        double out = sqrt(1.0 - cos2);
        for (int i = 0; i < 2 * STEPS; ++i) {
            double phi = pi * (i + 0.5) / STEPS;
            struct point world = {out * cos(phi), sqrt(cos2), out * sin(phi)};
            sum += map_at(map, turned(world, -degrees));
        }
    }
    return sum * pi / (2.0 * STEPS * STEPS);
}
