/tmp/w3_cli/build-asan/obj/lib/brdfcl/image.o: lib/brdfcl/image.c \
 include/brdfcl/image.h include/brdf/status.h include/brdfcl/api.h \
 lib/brdfcl/image_formats.h lib/brdfcl/atomic_file.h
include/brdfcl/image.h:
include/brdf/status.h:
include/brdfcl/api.h:
lib/brdfcl/image_formats.h:
lib/brdfcl/atomic_file.h:
