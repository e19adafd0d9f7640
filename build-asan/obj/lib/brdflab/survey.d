/tmp/w3_cli/build-asan/obj/lib/brdflab/survey.o: lib/brdflab/survey.c \
 lib/brdflab/survey.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/merl.h include/brdf/rgl.h include/brdf/warp.h \
 include/brdf/math.h include/brdf/real.h include/brdf/trigonometry.h \
 include/brdf/exponential.h include/brdf/erf.h lib/brdflab/albedo.h \
 lib/brdflab/draw.h lib/brdflab/lattice.h include/brdf/vec.h
lib/brdflab/survey.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
include/brdf/rgl.h:
include/brdf/warp.h:
include/brdf/math.h:
include/brdf/real.h:
include/brdf/trigonometry.h:
include/brdf/exponential.h:
include/brdf/erf.h:
lib/brdflab/albedo.h:
lib/brdflab/draw.h:
lib/brdflab/lattice.h:
include/brdf/vec.h:
