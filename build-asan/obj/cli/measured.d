/tmp/w3_cli/build-asan/obj/cli/measured.o: cli/measured.c cli/measured.h \
 include/brdf/merl.h include/brdf/status.h include/brdf/rgl.h \
 lib/brdflab/open.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h cli/options.h \
 lib/brdfcl/atomic_file.h include/brdf/status.h lib/brdflab/bake.h \
 lib/brdflab/complete.h lib/brdflab/copy.h lib/brdflab/tabulated.h \
 cli/commands.h cli/difference.h lib/brdflab/compare.h cli/json.h \
 cli/say.h cli/stop.h
cli/measured.h:
include/brdf/merl.h:
include/brdf/status.h:
include/brdf/rgl.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
cli/options.h:
lib/brdfcl/atomic_file.h:
include/brdf/status.h:
lib/brdflab/bake.h:
lib/brdflab/complete.h:
lib/brdflab/copy.h:
lib/brdflab/tabulated.h:
cli/commands.h:
cli/difference.h:
lib/brdflab/compare.h:
cli/json.h:
cli/say.h:
cli/stop.h:
