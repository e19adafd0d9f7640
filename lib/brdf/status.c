/* status.c - sentences for failures. */
#include "brdf/status.h"

#include <stdarg.h>
#include <stdio.h>

const char *brdf_status_text(brdf_status status)
{
    static const char *const sentences[] = {
#define BRDF_STATUS_SENTENCE(name, sentence) sentence,
        BRDF_STATUSES(BRDF_STATUS_SENTENCE)
#undef BRDF_STATUS_SENTENCE
    };
    return status >= 0 && status < BRDF_STATUS_COUNT ? sentences[status] : "no such status";
}

brdf_status brdf_fail(struct brdf_error *error, brdf_status status, const char *format, ...)
{
    if (error) {
        va_list arguments;
        va_start(arguments, format);
        error->status = status;
        if (vsnprintf(error->message, sizeof error->message, format, arguments) < 0) {
            error->message[0] = '\0';
        }
        va_end(arguments);
    }
    return status;
}
