/*
 * source.h - the text of the shared headers, for use in a client's own OpenCL program.
 *
 *   const char *kernel = "#include \"brdf/model/roughconductor.h\"\n"
 *                        "kernel void ...";
 *   char *text;
 *   if (!brdf_source_expand(kernel, "kernel.cl", NULL, &text, &error)) {
 *       program = clCreateProgramWithSource(context, 1, (const char **)&text, NULL, &status);
 *       free(text);
 *   }
 *
 * For the same bits as in C build with "-cl-std=CL1.2 -cl-fp32-correctly-rounded-divide-sqrt" and
 * -DBRDF_LANES=1, 4, 8, 16 or (with a compiler that is a clang, as PoCL's) 32. Nothing need be
 * installed where the program runs.
 */
#ifndef BRDF_SOURCE_H
#define BRDF_SOURCE_H

#include "status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A file of further text to include; a table of them ends with a NULL name. */
struct brdf_source_file {
    const char *name;         /* path that includes are resolved against: "kernels/path.h" */
    const char *const *lines; /* its lines without line ends, NULL after the last */
};

/*
 * The lines, without line ends and NULL after the last, of a shared header such as
 * "brdf/model/diffuse.h"; NULL if there is no such header. Not to be freed.
 */
BRDF_API const char *const *brdf_source_lines(const char *name);

/* The name of shared header number i; NULL from their count on. */
BRDF_API const char *brdf_source_name(int i);

/*
 * Replace every quoted include in `text` by the file, and so on inside it, so that no include path
 * is needed to compile the result. A name is looked up beside the including file, then in the root,
 * then under brdf/; in `more` (may be NULL) first, then among the shared headers. #line directives
 * let compilers name the real file; `text_name` is what they call `text`. Angle includes stay.
 *
 * A file with an include guard is put in once: later includes give only what is outside of its
 * guard. Conditions are not evaluated, so no quoted include may depend on one.
 *
 * On success *out is the caller's, to be freed with free(); on failure it is NULL. Fails if a file
 * is not known (UNKNOWN_NAME, with file, line and nearest name) or includes go round in a circle.
 */
BRDF_API brdf_status brdf_source_expand(const char *text, const char *text_name,
                                        const struct brdf_source_file *more, char **out,
                                        struct brdf_error *error);

#ifdef __cplusplus
}
#endif

#endif
