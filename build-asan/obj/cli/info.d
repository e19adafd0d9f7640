/tmp/w3_cli/build-asan/obj/cli/info.o: cli/info.c lib/brdflab/open.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdf/merl.h \
 lib/brdflab/survey.h include/brdf/rgl.h cli/commands.h cli/json.h \
 include/brdf/status.h cli/measured.h cli/options.h cli/say.h \
 cli/text_file.h
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
lib/brdflab/survey.h:
include/brdf/rgl.h:
cli/commands.h:
cli/json.h:
include/brdf/status.h:
cli/measured.h:
cli/options.h:
cli/say.h:
cli/text_file.h:
