/tmp/w3_cli/build-asan/obj/lib/brdflab/albedo.o: lib/brdflab/albedo.c \
 lib/brdflab/albedo.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/warp.h include/brdf/math.h include/brdf/real.h \
 include/brdf/trigonometry.h include/brdf/exponential.h \
 include/brdf/erf.h lib/brdflab/lattice.h include/brdf/vec.h
lib/brdflab/albedo.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/warp.h:
include/brdf/math.h:
include/brdf/real.h:
include/brdf/trigonometry.h:
include/brdf/exponential.h:
include/brdf/erf.h:
lib/brdflab/lattice.h:
include/brdf/vec.h:
