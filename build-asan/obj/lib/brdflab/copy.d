/tmp/w3_cli/build-asan/obj/lib/brdflab/copy.o: lib/brdflab/copy.c \
 lib/brdflab/copy.h include/brdf/status.h lib/brdfcl/atomic_file.h
lib/brdflab/copy.h:
include/brdf/status.h:
lib/brdfcl/atomic_file.h:
