/tmp/w3_cli/build-asan/obj/cli/say.o: cli/say.c cli/say.h \
 include/brdf/status.h cli/commands.h
cli/say.h:
include/brdf/status.h:
cli/commands.h:
