/tmp/w3_cli/build-asan/obj/cli/edit.o: cli/edit.c lib/brdflab/edit.h \
 include/brdf/merl.h include/brdf/status.h lib/brdflab/open.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h cli/commands.h cli/measured.h include/brdf/rgl.h \
 cli/options.h
lib/brdflab/edit.h:
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
