/tmp/w3_cli/build-asan/obj/lib/brdflab/bins.o: lib/brdflab/bins.c \
 lib/brdflab/bins.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/logrelative.h
lib/brdflab/bins.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/logrelative.h:
