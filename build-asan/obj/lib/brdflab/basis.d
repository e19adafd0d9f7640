/tmp/w3_cli/build-asan/obj/lib/brdflab/basis.o: lib/brdflab/basis.c \
 lib/brdflab/basis.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/trait.h lib/brdflab/basis_traits.h lib/brdflab/bins.h \
 lib/brdflab/complete.h lib/brdflab/logrelative.h
lib/brdflab/basis.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/trait.h:
lib/brdflab/basis_traits.h:
lib/brdflab/bins.h:
lib/brdflab/complete.h:
lib/brdflab/logrelative.h:
