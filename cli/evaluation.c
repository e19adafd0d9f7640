/* evaluation.c - f and pdf of a material, by C or by OpenCL. */
#include "evaluation.h"

#include <string.h>

#include "brdflab/open.h"

brdf_status evaluation_open(struct evaluation *evaluation, const struct backend *backend,
                            const char *description, int fill, struct brdf_error *error)
{
    memset(evaluation, 0, sizeof *evaluation);
    brdf_status status = lab_open_filled(description, fill, &evaluation->bsdf, NULL, error);
    if (!status) {
        status = backend_open(backend, &evaluation->device, error);
    }
    if (!status && evaluation->device) {
        status = brdfcl_evaluator_create(evaluation->device, evaluation->bsdf,
                                         &evaluation->evaluator, error);
    }
    return status;
}

void evaluation_close(struct evaluation *evaluation)
{
    brdfcl_evaluator_destroy(evaluation->evaluator);
    brdfcl_device_close(evaluation->device);
    brdf_bsdf_destroy(evaluation->bsdf);
    memset(evaluation, 0, sizeof *evaluation);
}

brdf_status evaluation_run(const struct evaluation *evaluation, size_t count,
                           struct brdf_vectors wo, struct brdf_vectors wi, struct brdf_colors f,
                           float *pdf, struct brdf_error *error)
{
    if (!evaluation->evaluator) {
        brdf_eval_many(evaluation->bsdf, count, wo, wi, f);
        brdf_pdf_many(evaluation->bsdf, count, wo, wi, pdf);
        return BRDF_OK;
    }
    brdf_status status = brdfcl_evaluator_eval(evaluation->evaluator, count, wo, wi, f, error);
    return status ? status : brdfcl_evaluator_pdf(evaluation->evaluator, count, wo, wi, pdf, error);
}
