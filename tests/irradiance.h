/*
 * irradiance.h - what an upward floor at the origin receives from lights above it, as geometry
 * says.
 */
#ifndef TEST_IRRADIANCE_H
#define TEST_IRRADIANCE_H

#include <stddef.h>

#include <brdfcl/image.h>

struct point {
    double x, y, z;
};

/* The size of maps here. */
enum { MAP_WIDTH = 12, MAP_HEIGHT = 7 };

/* A polygon of radiance 1 that lies above the floor entirely [Lambert 1760]. */
double polygon_irradiance(const struct point *corner, size_t count);

/* A disk as a polygon of many corners: off by less than one in a million. */
double disk_irradiance(struct point centre, struct point a, struct point b);

/* A sphere that is above the horizon entirely: as if all light came from its centre. */
double sphere_irradiance(struct point centre, double radius);

/* Corners of a rectangle -1..1 that is scaled, turned to look down, and moved. */
double rectangle_irradiance(double half_x, double half_z, struct point centre);

/* A map that is turned by an angle about (0.48, 0.6, 0.64), by midpoints. */
double map_irradiance(const struct brdfcl_image *map, double degrees);

#endif
