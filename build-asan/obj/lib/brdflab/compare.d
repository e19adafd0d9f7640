/tmp/w3_cli/build-asan/obj/lib/brdflab/compare.o: lib/brdflab/compare.c \
 lib/brdflab/compare.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/merl.h lib/brdflab/draw.h lib/brdflab/lattice.h \
 include/brdf/vec.h lib/brdflab/tabulated.h
lib/brdflab/compare.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
lib/brdflab/draw.h:
lib/brdflab/lattice.h:
include/brdf/vec.h:
lib/brdflab/tabulated.h:
