/tmp/w3_cli/build-asan/obj/cli/json.o: cli/json.c cli/json.h \
 include/brdf/status.h cli/text_file.h
cli/json.h:
include/brdf/status.h:
cli/text_file.h:
