/*
 * table_fill.h - numbers between those of a table that were computed (internal).
 */
#ifndef BRDF_TABLE_FILL_H
#define BRDF_TABLE_FILL_H

/*
 * Of `count` numbers in [0, 1], `stride` words apart, every `step`th is there, four at least: fill
 * in the others from the first to the last that are told, by cubic polynomials through four.
 */
void brdf_table_fill(float *numbers, int count, int first, int last, int stride, int step);

#endif
