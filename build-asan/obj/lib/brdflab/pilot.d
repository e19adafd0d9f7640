/tmp/w3_cli/build-asan/obj/lib/brdflab/pilot.o: lib/brdflab/pilot.c \
 lib/brdflab/pilot.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 lib/brdfcl/check_random.h lib/brdflab/sphere.h include/brdf/vec.h \
 include/brdf/math.h include/brdf/real.h include/brdf/trigonometry.h \
 include/brdf/exponential.h include/brdf/erf.h
lib/brdflab/pilot.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdfcl/check_random.h:
lib/brdflab/sphere.h:
include/brdf/vec.h:
include/brdf/math.h:
include/brdf/real.h:
include/brdf/trigonometry.h:
include/brdf/exponential.h:
include/brdf/erf.h:
