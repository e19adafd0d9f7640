/tmp/w3_cli/build-asan/obj/cli/parse.o: cli/parse.c cli/parse.h \
 include/brdf/vec.h include/brdf/dialect.h
cli/parse.h:
include/brdf/vec.h:
include/brdf/dialect.h:
