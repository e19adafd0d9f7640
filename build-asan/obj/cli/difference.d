/tmp/w3_cli/build-asan/obj/cli/difference.o: cli/difference.c \
 cli/difference.h lib/brdflab/compare.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/merl.h cli/json.h \
 include/brdf/status.h cli/parse.h include/brdf/vec.h
cli/difference.h:
lib/brdflab/compare.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
cli/json.h:
include/brdf/status.h:
cli/parse.h:
include/brdf/vec.h:
