/tmp/w3_cli/build-asan/obj/cli/convert.o: cli/convert.c \
 lib/brdflab/complete.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/open.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h lib/brdflab/survey.h \
 include/brdf/rgl.h cli/commands.h cli/difference.h lib/brdflab/compare.h \
 cli/json.h include/brdf/status.h cli/measured.h cli/options.h cli/say.h \
 cli/text_file.h
lib/brdflab/complete.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
lib/brdflab/survey.h:
include/brdf/rgl.h:
cli/commands.h:
cli/difference.h:
lib/brdflab/compare.h:
cli/json.h:
include/brdf/status.h:
cli/measured.h:
cli/options.h:
cli/say.h:
cli/text_file.h:
