/tmp/w3_cli/build-asan/obj/cli/models.o: cli/models.c include/brdf/info.h \
 include/brdf/parameters.h include/brdf/choices.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/substance.h lib/brdflab/bake.h \
 include/brdf/merl.h include/brdf/rgl.h cli/commands.h cli/options.h \
 cli/say.h include/brdf/status.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/substance.h:
lib/brdflab/bake.h:
include/brdf/merl.h:
include/brdf/rgl.h:
cli/commands.h:
cli/options.h:
cli/say.h:
include/brdf/status.h:
