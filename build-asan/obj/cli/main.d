/tmp/w3_cli/build-asan/obj/cli/main.o: cli/main.c include/brdf/info.h \
 include/brdf/parameters.h include/brdf/choices.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h cli/commands.h cli/say.h \
 include/brdf/status.h cli/stop.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
cli/commands.h:
cli/say.h:
include/brdf/status.h:
cli/stop.h:
