/tmp/w3_cli/build-asan/obj/lib/brdfcl/image_png_read.o: \
 lib/brdfcl/image_png_read.c lib/brdfcl/image_png.h \
 lib/brdfcl/image_formats.h include/brdfcl/image.h include/brdf/status.h \
 include/brdfcl/api.h lib/brdfcl/atomic_file.h
lib/brdfcl/image_png.h:
lib/brdfcl/image_formats.h:
include/brdfcl/image.h:
include/brdf/status.h:
include/brdfcl/api.h:
lib/brdfcl/atomic_file.h:
