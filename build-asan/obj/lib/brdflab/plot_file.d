/tmp/w3_cli/build-asan/obj/lib/brdflab/plot_file.o: \
 lib/brdflab/plot_file.c lib/brdflab/plot_file.h include/brdf/status.h \
 lib/brdfcl/atomic_file.h lib/brdflab/plot.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h lib/brdflab/section.h
lib/brdflab/plot_file.h:
include/brdf/status.h:
lib/brdfcl/atomic_file.h:
lib/brdflab/plot.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/section.h:
