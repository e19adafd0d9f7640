/tmp/w3_cli/build-asan/obj/lib/brdflab/fit_search.o: \
 lib/brdflab/fit_search.c lib/brdflab/fit_search.h lib/brdflab/fit.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h lib/brdflab/fit_samples.h \
 lib/brdflab/fit_space.h lib/brdflab/fit_part.h include/brdf/info.h \
 include/brdf/parameters.h include/brdf/choices.h
lib/brdflab/fit_search.h:
lib/brdflab/fit.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/fit_samples.h:
lib/brdflab/fit_space.h:
lib/brdflab/fit_part.h:
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
