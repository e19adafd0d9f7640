/tmp/w3_cli/build-asan/obj/lib/brdflab/lattice.o: lib/brdflab/lattice.c \
 lib/brdflab/lattice.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/math.h include/brdf/real.h include/brdf/trigonometry.h \
 include/brdf/exponential.h include/brdf/erf.h lib/brdfcl/check_random.h
lib/brdflab/lattice.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/math.h:
include/brdf/real.h:
include/brdf/trigonometry.h:
include/brdf/exponential.h:
include/brdf/erf.h:
lib/brdfcl/check_random.h:
