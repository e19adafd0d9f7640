/*
 * number.h - numbers and colours as text, the same in every locale (internal).
 */
#ifndef BRDF_NUMBER_H
#define BRDF_NUMBER_H

/* Room for any float that brdf_number_write writes. */
enum { BRDF_NUMBER_SIZE = 32 };

/* 1 if the whole text, but for spaces around it, is one number (which may be infinite or NaN). */
int brdf_number_read(const char *text, float *x);

/* 1 if it is a colour: one number, three separated by "/", "," or spaces, or #rrggbb in sRGB. */
int brdf_color_read(const char *text, float rgb[3]);

/* The fewest digits that brdf_number_read makes the same float of. */
void brdf_number_write(char text[BRDF_NUMBER_SIZE], float x);

#endif
