/*
 * angle.h - numbers about angles, for host code.
 */
#ifndef ANGLE_H
#define ANGLE_H

static const double pi = 3.14159265358979323846;
static const double degree = 3.14159265358979323846 / 180.0; /* [rad] */

#endif
