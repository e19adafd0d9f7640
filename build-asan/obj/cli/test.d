/tmp/w3_cli/build-asan/obj/cli/test.o: cli/test.c cli/test.h \
 lib/brdflab/trial.h include/brdf/info.h include/brdf/parameters.h \
 include/brdf/choices.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/material.h include/brdf/sample.h \
 lib/brdflab/finding.h include/brdf/vec.h cli/json.h \
 include/brdf/status.h cli/options.h lib/brdflab/open.h \
 include/brdf/merl.h cli/commands.h cli/say.h cli/text_file.h
cli/test.h:
lib/brdflab/trial.h:
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/material.h:
include/brdf/sample.h:
lib/brdflab/finding.h:
include/brdf/vec.h:
cli/json.h:
include/brdf/status.h:
cli/options.h:
lib/brdflab/open.h:
include/brdf/merl.h:
cli/commands.h:
cli/say.h:
cli/text_file.h:
