/tmp/w3_cli/build-asan/obj/cli/text_file.o: cli/text_file.c \
 cli/text_file.h include/brdf/status.h lib/brdfcl/atomic_file.h \
 cli/stop.h
cli/text_file.h:
include/brdf/status.h:
lib/brdfcl/atomic_file.h:
cli/stop.h:
