/tmp/w3_cli/build-asan/obj/lib/brdflab/edit.o: lib/brdflab/edit.c \
 lib/brdflab/edit.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/bins.h lib/brdflab/oklab.h lib/brdflab/separate.h
lib/brdflab/edit.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/bins.h:
lib/brdflab/oklab.h:
lib/brdflab/separate.h:
