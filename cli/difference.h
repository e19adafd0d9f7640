/*
 * difference.h - what tabulating a material changed, printed and as JSON, alike in all commands.
 */
#ifndef BRDFCL_DIFFERENCE_H
#define BRDFCL_DIFFERENCE_H

#include "brdflab/compare.h"
#include "json.h"

void difference_print(const struct lab_difference *difference);

/* Members of the object that is open. */
void difference_put(struct json *json, const struct lab_difference *difference);

#endif
