/tmp/w3_cli/build-asan/obj/lib/brdflab/fit_samples.o: \
 lib/brdflab/fit_samples.c include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/fit_samples.h lib/brdflab/fit.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/fit_samples.h:
lib/brdflab/fit.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
