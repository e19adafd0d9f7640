/*
 * parse.h - numbers and the like from a command line: the whole text or nothing.
 */
#ifndef BRDFCL_PARSE_H
#define BRDFCL_PARSE_H

#include <brdf/vec.h>

/* How a text was read. */
enum parse_result {
    PARSE_OK,
    PARSE_RANGE,    /* what was wanted, but too small or too large */
    PARSE_MALFORMED /* something else */
};

/* A direction as a person types it: degrees from the normal and around it. */
struct angles {
    double theta; /* degrees, 0 to 180 */
    double phi;   /* degrees */
    int given;
};

struct size {
    int width;
    int height;
};

/* "0,30,60" */
struct numbers {
    double item[256];
    int count;
};

enum parse_result parse_int(const char *text, double low, double high, int *value);
enum parse_result parse_real(const char *text, double low, double high, double *value);

/* Numbers between commas, each in its range, at least one. */
enum parse_result parse_list(const char *text, double low, double high, struct numbers *list);

/* "THETA,PHI" */
enum parse_result parse_angles(const char *text, struct angles *value);

/* "WIDTHxHEIGHT" */
enum parse_result parse_size(const char *text, double low, double high, struct size *value);

/* The unit vector of a direction; exact at multiples of 90 degrees, so that grazing is z = 0. */
brdf_vec3 direction_of_angles(struct angles angles);

/* And back; phi in (-180, 180]. */
struct angles angles_of_direction(brdf_vec3 w);

#endif
