/*
 * aliases.h - other names of models, as other programs call them: one line each (internal).
 *
 *   BRDF_MODEL_ALIAS(alias, MODEL)
 *
 * Who reads the list defines BRDF_MODEL_ALIAS before and undefines it after.
 */
BRDF_MODEL_ALIAS(roughdiffuse, ORENNAYAR) /* Mitsuba 0.6 */
