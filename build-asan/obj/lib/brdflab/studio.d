/tmp/w3_cli/build-asan/obj/lib/brdflab/studio.o: lib/brdflab/studio.c \
 lib/brdflab/studio.h include/brdf/frame.h include/brdf/vec.h \
 include/brdf/dialect.h
lib/brdflab/studio.h:
include/brdf/frame.h:
include/brdf/vec.h:
include/brdf/dialect.h:
