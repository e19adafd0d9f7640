/tmp/w3_cli/build-asan/obj/lib/brdflab/draw.o: lib/brdflab/draw.c \
 lib/brdflab/draw.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/warp.h include/brdf/math.h include/brdf/real.h \
 include/brdf/trigonometry.h include/brdf/exponential.h \
 include/brdf/erf.h
lib/brdflab/draw.h:
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
