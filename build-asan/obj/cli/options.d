/tmp/w3_cli/build-asan/obj/cli/options.o: cli/options.c cli/options.h \
 include/brdf/info.h include/brdf/parameters.h include/brdf/choices.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 cli/commands.h cli/parse.h include/brdf/vec.h cli/say.h \
 include/brdf/status.h
cli/options.h:
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
cli/commands.h:
cli/parse.h:
include/brdf/vec.h:
cli/say.h:
include/brdf/status.h:
