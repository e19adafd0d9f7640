/tmp/w3_cli/build-asan/obj/cli/sample.o: cli/sample.c \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h lib/brdflab/open.h \
 include/brdf/merl.h cli/commands.h cli/measured.h include/brdf/rgl.h \
 cli/options.h cli/parse.h include/brdf/vec.h cli/random.h cli/say.h \
 include/brdf/status.h
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/open.h:
include/brdf/merl.h:
cli/commands.h:
cli/measured.h:
include/brdf/rgl.h:
cli/options.h:
cli/parse.h:
include/brdf/vec.h:
cli/random.h:
cli/say.h:
include/brdf/status.h:
