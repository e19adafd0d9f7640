/tmp/w3_cli/build-asan/obj/lib/brdflab/trait.o: lib/brdflab/trait.c \
 lib/brdflab/bins.h include/brdf/merl.h include/brdf/status.h \
 lib/brdf/luminance.h lib/brdflab/trait.h
lib/brdflab/bins.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdf/luminance.h:
lib/brdflab/trait.h:
