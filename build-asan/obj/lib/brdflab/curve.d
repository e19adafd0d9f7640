/tmp/w3_cli/build-asan/obj/lib/brdflab/curve.o: lib/brdflab/curve.c \
 lib/brdflab/curve.h include/brdf/status.h
lib/brdflab/curve.h:
include/brdf/status.h:
