/*
 * status.h - how host functions fail: a status to branch on and a sentence to show.
 *
 * A function that can fail returns a brdf_status and takes a struct brdf_error * as its last
 * argument, owned by the caller; NULL means that the sentence is not wanted. The sentence says what
 * is wrong, where (file, line, byte) and what to do. On success the error is left untouched.
 */
#ifndef BRDF_STATUS_H
#define BRDF_STATUS_H

#ifdef __cplusplus
extern "C" {
#endif

#ifndef BRDF_API
#ifdef __GNUC__
#define BRDF_API __attribute__((visibility("default")))
#else
#define BRDF_API
#endif
#endif

/* F(name, sentence): every status, once. */
#define BRDF_STATUSES(F)                                                                           \
    F(OK, "success")                                                                               \
    F(BAD_ARGUMENT, "an argument is not valid")                                                    \
    F(UNKNOWN_NAME, "no such model, parameter or option")                                          \
    F(OUT_OF_RANGE, "a value is outside its range")                                                \
    F(BAD_FILE, "the content of a file is not valid")                                              \
    F(IO, "a file could not be read or written")                                                   \
    F(UNSUPPORTED, "valid, but not supported")                                                     \
    F(OUT_OF_MEMORY, "out of memory")                                                              \
    F(NO_DEVICE, "no such OpenCL platform or device")                                              \
    F(DEVICE, "an OpenCL call failed")                                                             \
    F(CANCELLED, "stopped on request")

enum brdf_status_value {
#define BRDF_STATUS_ENUM(name, sentence) BRDF_##name,
    BRDF_STATUSES(BRDF_STATUS_ENUM)
#undef BRDF_STATUS_ENUM
        BRDF_STATUS_COUNT
};

/* One of enum brdf_status_value; an int, so that its size never depends on the list. */
typedef int brdf_status;

struct brdf_error {
    brdf_status status;
    char message[1024]; /* one sentence, always terminated */
};

/* The sentence of a status by itself; never NULL, never to be freed. */
BRDF_API const char *brdf_status_text(brdf_status status);

/*
 * Fill the error (unless it is NULL) with a sentence made as printf would, and return the status,
 * so that a function can end with `return brdf_fail(error, BRDF_IO, "%s: %s", path, reason)`.
 */
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
BRDF_API brdf_status
brdf_fail(struct brdf_error *error, brdf_status status, const char *format, ...);

#ifdef __cplusplus
}
#endif

#endif
