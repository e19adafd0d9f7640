/tmp/w3_cli/build-asan/obj/lib/brdflab/sphere.o: lib/brdflab/sphere.c \
 lib/brdflab/sphere.h include/brdf/vec.h include/brdf/dialect.h
lib/brdflab/sphere.h:
include/brdf/vec.h:
include/brdf/dialect.h:
