/tmp/w3_cli/build-asan/obj/cli/navigate.o: cli/navigate.c \
 include/brdf/info.h include/brdf/parameters.h include/brdf/choices.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 lib/brdflab/complete.h include/brdf/merl.h lib/brdflab/open.h \
 include/brdf/material.h include/brdf/sample.h lib/brdflab/place.h \
 lib/brdflab/basis.h lib/brdflab/trait.h cli/commands.h cli/measured.h \
 include/brdf/rgl.h cli/options.h cli/navigate_list.h \
 include/brdf/status.h cli/navigate_print.h lib/brdflab/basis.h \
 cli/parse.h include/brdf/vec.h cli/say.h cli/stop.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/complete.h:
include/brdf/merl.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
lib/brdflab/place.h:
lib/brdflab/basis.h:
lib/brdflab/trait.h:
cli/commands.h:
cli/measured.h:
include/brdf/rgl.h:
cli/options.h:
cli/navigate_list.h:
include/brdf/status.h:
cli/navigate_print.h:
lib/brdflab/basis.h:
cli/parse.h:
include/brdf/vec.h:
cli/say.h:
cli/stop.h:
