/* number.c - numbers and colours as text, the same in every locale. */
#define _POSIX_C_SOURCE 200809L

#include "number.h"

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char spaces[] = " \t\r\n";

/* Where the number at the start of the text ends; NULL if there is none. */
static const char *read_one(const char *text, float *x)
{
    char *end = NULL;
    locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    locale_t former = plain ? uselocale(plain) : (locale_t)0;
    *x = strtof(text, &end);
    if (plain) {
        uselocale(former);
        freelocale(plain);
    }
    return end == text ? NULL : end;
}

int brdf_number_read(const char *text, float *x)
{
    const char *end = read_one(text, x);
    return end && end[strspn(end, spaces)] == '\0';
}

/* IEC 61966-2-1. */
static float linear_from_srgb(unsigned byte)
{
    double c = byte / 255.0;
    return (float)(c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4));
}

static int read_hexadecimal(const char *digits, float rgb[3])
{
    size_t count = strspn(digits, "0123456789abcdefABCDEF");
    if (count != 6 || digits[6 + strspn(digits + 6, spaces)] != '\0') {
        return 0;
    }
    unsigned long value = strtoul(digits, NULL, 16);
    for (int i = 0; i < 3; ++i) {
        rgb[i] = linear_from_srgb((unsigned)(value >> (16 - 8 * i) & 255));
    }
    return 1;
}

int brdf_color_read(const char *text, float rgb[3])
{
    text += strspn(text, spaces);
    if (*text == '#') {
        return read_hexadecimal(text + 1, rgb);
    }
    int count = 0;
    while (count < 3) {
        text = read_one(text, &rgb[count]);
        if (!text) {
            return 0;
        }
        ++count;
        const char *gap = text;
        text += strspn(text, spaces);
        if (*text == '\0') {
            break;
        }
        int mark = count < 3 && (*text == '/' || *text == ',');
        if (!mark && gap == text) {
            return 0;
        }
        text += mark;
    }
    if (count == 1) {
        rgb[1] = rgb[2] = rgb[0];
    }
    return count != 2 && *text == '\0';
}

void brdf_number_write(char text[BRDF_NUMBER_SIZE], float x)
{
    for (int digits = 6; digits <= 9; ++digits) { /* 9 are enough for every float */
        float again;
        snprintf(text, BRDF_NUMBER_SIZE, "%.*g", digits, (double)x);
        char *comma = strpbrk(text, ",");
        if (comma) { /* a locale's decimal point */
            *comma = '.';
        }
        if (brdf_number_read(text, &again) && memcmp(&again, &x, sizeof x) == 0) {
            break;
        }
    }
}
