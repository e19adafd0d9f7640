/tmp/w3_cli/build-asan/obj/cli/evaluation_file.o: cli/evaluation_file.c \
 cli/evaluation.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdfcl/evaluate.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h cli/backend.h
cli/evaluation.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdfcl/evaluate.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
cli/backend.h:
