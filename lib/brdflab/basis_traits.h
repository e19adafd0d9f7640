/*
 * basis_traits.h - how traits change with the coordinates of a basis.
 */
#ifndef BRDFLAB_BASIS_TRAITS_H
#define BRDFLAB_BASIS_TRAITS_H

#include "basis.h"

/* Fill in slopes, deviations and what is explained, once traits and coordinates are known. */
void basis_traits_regress(struct lab_basis *basis);

#endif
