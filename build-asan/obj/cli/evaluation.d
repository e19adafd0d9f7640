/tmp/w3_cli/build-asan/obj/cli/evaluation.o: cli/evaluation.c \
 cli/evaluation.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdfcl/evaluate.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h cli/backend.h lib/brdflab/open.h \
 include/brdf/merl.h
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
lib/brdflab/open.h:
include/brdf/merl.h:
