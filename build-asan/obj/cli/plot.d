/tmp/w3_cli/build-asan/obj/cli/plot.o: cli/plot.c include/brdf/info.h \
 include/brdf/parameters.h include/brdf/choices.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdf/material.h \
 include/brdf/sample.h lib/brdflab/open.h include/brdf/merl.h \
 lib/brdflab/plot.h lib/brdflab/section.h cli/commands.h cli/measured.h \
 include/brdf/rgl.h cli/options.h cli/parse.h include/brdf/vec.h \
 cli/say.h include/brdf/status.h cli/stop.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/material.h:
include/brdf/sample.h:
lib/brdflab/open.h:
include/brdf/merl.h:
lib/brdflab/plot.h:
lib/brdflab/section.h:
cli/commands.h:
cli/measured.h:
include/brdf/rgl.h:
cli/options.h:
cli/parse.h:
include/brdf/vec.h:
cli/say.h:
include/brdf/status.h:
cli/stop.h:
