/*
 * brdf.h - the whole host API of libbrdf: materials by name, evaluated, sampled and looked into.
 */
#ifndef BRDF_BRDF_H
#define BRDF_BRDF_H

#include "info.h"
#include "material.h"
#include "merl.h"
#include "rgl.h"
#include "source.h"
#include "status.h"
#include "substance.h"

#endif
