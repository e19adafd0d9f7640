/* parse.c - numbers and directions from a command line. */
#include "parse.h"
#include "angle.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* strtol and strtod would skip spaces, and read "inf" and "0x10". */
static int begins_number(const char *text)
{
    return *text && strspn(text, "+-.0123456789eE") == strlen(text);
}

enum parse_result parse_int(const char *text, double low, double high, int *value)
{
    char *end;
    if (!*text || strspn(text, "+-0123456789") != strlen(text)) {
        return PARSE_MALFORMED;
    }
    errno = 0;
    long number = strtol(text, &end, 10);
    if (end == text || *end) {
        return PARSE_MALFORMED;
    }
    if (errno == ERANGE || (double)number < low || (double)number > high) {
        return PARSE_RANGE;
    }
    *value = (int)number;
    return PARSE_OK;
}

enum parse_result parse_real(const char *text, double low, double high, double *value)
{
    char *end;
    if (!begins_number(text)) {
        return PARSE_MALFORMED;
    }
    double number = strtod(text, &end);
    if (end == text || *end) {
        return PARSE_MALFORMED;
    }
    if (!(number >= low && number <= high)) {
        return PARSE_RANGE;
    }
    *value = number;
    return PARSE_OK;
}

/* The text before and after a mark, as copies; 0 where there is no mark or too much text. */
static int split(const char *text, char mark, char parts[2][64])
{
    const char *at = strchr(text, mark);
    if (!at || (size_t)(at - text) >= sizeof parts[0] || strlen(at + 1) >= sizeof parts[1]) {
        return 0;
    }
    memcpy(parts[0], text, (size_t)(at - text));
    parts[0][at - text] = '\0';
    strcpy(parts[1], at + 1);
    return 1;
}

enum parse_result parse_list(const char *text, double low, double high, struct numbers *list)
{
    char number[64];
    for (list->count = 0;; ++list->count) {
        size_t span = strcspn(text, ",");
        if (span >= sizeof number) {
            return PARSE_MALFORMED;
        }
        if (list->count == (int)(sizeof list->item / sizeof list->item[0])) {
            return PARSE_RANGE;
        }
        memcpy(number, text, span);
        number[span] = '\0';
        enum parse_result result = parse_real(number, low, high, &list->item[list->count]);
        if (result != PARSE_OK) {
            return result;
        }
        text += span;
        if (!*text++) {
            ++list->count;
            return PARSE_OK;
        }
    }
}

enum parse_result parse_angles(const char *text, struct angles *value)
{
    char parts[2][64];
    if (!split(text, ',', parts)) {
        return PARSE_MALFORMED;
    }
    enum parse_result theta = parse_real(parts[0], 0.0, 180.0, &value->theta);
    enum parse_result phi = parse_real(parts[1], -1e6, 1e6, &value->phi);
    value->given = 1;
    return theta > phi ? theta : phi;
}

enum parse_result parse_size(const char *text, double low, double high, struct size *value)
{
    char parts[2][64];
    if (!split(text, 'x', parts)) {
        return PARSE_MALFORMED;
    }
    enum parse_result width = parse_int(parts[0], low, high, &value->width);
    enum parse_result height = parse_int(parts[1], low, high, &value->height);
    return width > height ? width : height;
}

/* Sine and cosine of an angle in degrees, turned into [-45, 45] first. */
static void sincos_degrees(double degrees, double *sine, double *cosine)
{
    double quarter = floor(degrees / 90.0 + 0.5);
    double rest = (degrees - quarter * 90.0) * (pi / 180.0);
    double s = sin(rest), c = cos(rest);
    switch ((int)(quarter - 4.0 * floor(quarter / 4.0))) {
    case 0:
        *sine = s, *cosine = c;
        break;
    case 1:
        *sine = c, *cosine = -s;
        break;
    case 2:
        *sine = -s, *cosine = -c;
        break;
    default:
        *sine = -c, *cosine = s;
        break;
    }
    *sine += 0.0; /* no negative zero */
    *cosine += 0.0;
}

brdf_vec3 direction_of_angles(struct angles angles)
{
    double sin_theta, cos_theta, sin_phi, cos_phi;
    sincos_degrees(angles.theta, &sin_theta, &cos_theta);
    sincos_degrees(angles.phi, &sin_phi, &cos_phi);
    return brdf_vec3_make((float)(sin_theta * cos_phi), (float)(sin_theta * sin_phi),
                          (float)cos_theta);
}

struct angles angles_of_direction(brdf_vec3 w)
{
    double sine = sqrt((double)w.x * (double)w.x + (double)w.y * (double)w.y);
    struct angles angles = {atan2(sine, (double)w.z) * (180.0 / pi),
                            atan2((double)w.y + 0.0, (double)w.x) * (180.0 / pi), 1};
    return angles;
}
