/tmp/w3_cli/build-asan/obj/lib/brdfcl/image_exr_write.o: \
 lib/brdfcl/image_exr_write.c lib/brdfcl/image_formats.h \
 include/brdfcl/image.h include/brdf/status.h include/brdfcl/api.h \
 lib/brdfcl/atomic_file.h
lib/brdfcl/image_formats.h:
include/brdfcl/image.h:
include/brdf/status.h:
include/brdfcl/api.h:
lib/brdfcl/atomic_file.h:
