/tmp/w3_cli/build-asan/obj/lib/brdflab/mix.o: lib/brdflab/mix.c \
 lib/brdflab/mix.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/bins.h lib/brdflab/logrelative.h
lib/brdflab/mix.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/bins.h:
lib/brdflab/logrelative.h:
