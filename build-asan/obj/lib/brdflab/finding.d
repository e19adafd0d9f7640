/tmp/w3_cli/build-asan/obj/lib/brdflab/finding.o: lib/brdflab/finding.c \
 lib/brdflab/finding.h include/brdf/vec.h include/brdf/dialect.h
lib/brdflab/finding.h:
include/brdf/vec.h:
include/brdf/dialect.h:
