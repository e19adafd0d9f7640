/tmp/w3_cli/build-asan/obj/cli/eval.o: cli/eval.c cli/backend.h \
 include/brdfcl/device.h include/brdf/status.h include/brdfcl/api.h \
 cli/commands.h cli/evaluation.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdfcl/evaluate.h cli/measured.h \
 include/brdf/merl.h include/brdf/rgl.h lib/brdflab/open.h cli/options.h \
 cli/parse.h include/brdf/vec.h cli/say.h
cli/backend.h:
include/brdfcl/device.h:
include/brdf/status.h:
include/brdfcl/api.h:
cli/commands.h:
cli/evaluation.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdfcl/evaluate.h:
cli/measured.h:
include/brdf/merl.h:
include/brdf/rgl.h:
lib/brdflab/open.h:
cli/options.h:
cli/parse.h:
include/brdf/vec.h:
cli/say.h:
