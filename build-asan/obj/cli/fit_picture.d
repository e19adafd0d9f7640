/tmp/w3_cli/build-asan/obj/cli/fit_picture.o: cli/fit_picture.c \
 cli/fit_picture.h lib/brdflab/fit.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/merl.h lib/brdflab/bake.h \
 include/brdf/rgl.h lib/brdflab/plot.h lib/brdflab/section.h cli/stop.h
cli/fit_picture.h:
lib/brdflab/fit.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
lib/brdflab/bake.h:
include/brdf/rgl.h:
lib/brdflab/plot.h:
lib/brdflab/section.h:
cli/stop.h:
