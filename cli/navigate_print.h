/*
 * navigate_print.h - a map of materials, and a place of it, as text.
 */
#ifndef BRDFCL_NAVIGATE_PRINT_H
#define BRDFCL_NAVIGATE_PRINT_H

#include "brdflab/basis.h"
#include "navigate_list.h"

/* Components, coordinates of the materials of `list`, and how well the components tell traits. */
void navigate_print_map(const struct lab_basis *basis, const struct navigate_list *list);

/* The coordinates, start + step, of what was written to `path`; far ones are warned of. */
void navigate_print_place(const char *path, const struct lab_basis *basis, const double *start,
                          const double *step);

#endif
