/tmp/w3_cli/build-asan/obj/lib/brdflab/place.o: lib/brdflab/place.c \
 lib/brdflab/place.h lib/brdflab/basis.h include/brdf/merl.h \
 include/brdf/status.h lib/brdflab/trait.h lib/brdflab/bins.h \
 lib/brdflab/complete.h lib/brdflab/logrelative.h
lib/brdflab/place.h:
lib/brdflab/basis.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/trait.h:
lib/brdflab/bins.h:
lib/brdflab/complete.h:
lib/brdflab/logrelative.h:
