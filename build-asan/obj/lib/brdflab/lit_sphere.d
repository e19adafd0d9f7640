/tmp/w3_cli/build-asan/obj/lib/brdflab/lit_sphere.o: \
 lib/brdflab/lit_sphere.c lib/brdflab/lit_sphere.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h lib/brdflab/lattice.h \
 include/brdf/vec.h lib/brdflab/studio.h include/brdf/frame.h
lib/brdflab/lit_sphere.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/lattice.h:
include/brdf/vec.h:
lib/brdflab/studio.h:
include/brdf/frame.h:
