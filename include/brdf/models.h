/*
 * models.h - the list of models: one line each. To add a model, write its file and add its line.
 *
 * Each model file defines its struct and functions once (inside its include guard) and then,
 * outside the guard, announces itself:
 *
 *   BRDF_MODEL(name, NAME, flags, summary, reference)
 *
 * Whoever needs code per model defines BRDF_MODEL, includes this list, and undefines it again; that
 * is why this file has no include guard. model.h does it for the tag, the union and the dispatch.
 */
#include "model/diffuse.h"
#include "model/phong.h"
#include "model/blinnphong.h"
#include "model/ward.h"
#include "model/ashikhminshirley.h"
#include "model/torrancesparrow.h"
#include "model/cooktorrance.h"
#include "model/abc.h"
#include "model/roughconductor.h"
#include "model/dielectric.h"
#include "model/conductor.h"
#include "model/thindielectric.h"
#include "model/roughdielectric.h"
#include "model/plastic.h"
#include "model/orennayar.h"
#include "model/lommelseeliger.h"
#include "model/hapke.h"
#include "model/roughplastic.h"
#include "model/principled.h"
#include "model/wood.h"
#include "model/merl.h"
#include "model/measuredmix.h"
#include "model/measured.h"
