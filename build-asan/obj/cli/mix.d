/tmp/w3_cli/build-asan/obj/cli/mix.o: cli/mix.c lib/brdflab/mix.h \
 include/brdf/merl.h include/brdf/status.h lib/brdflab/open.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h cli/commands.h cli/measured.h include/brdf/rgl.h \
 cli/options.h cli/parse.h include/brdf/vec.h cli/say.h \
 include/brdf/status.h
lib/brdflab/mix.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
cli/commands.h:
cli/measured.h:
include/brdf/rgl.h:
cli/options.h:
cli/parse.h:
include/brdf/vec.h:
cli/say.h:
include/brdf/status.h:
