/tmp/w3_cli/build-asan/obj/lib/brdfcl/atomic_file.o: \
 lib/brdfcl/atomic_file.c lib/brdfcl/atomic_file.h include/brdf/status.h
lib/brdfcl/atomic_file.h:
include/brdf/status.h:
