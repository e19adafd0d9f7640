/tmp/w3_cli/build-asan/obj/lib/brdflab/separate.o: lib/brdflab/separate.c \
 lib/brdflab/separate.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/bins.h
lib/brdflab/separate.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/bins.h:
