/tmp/w3_cli/build-asan/obj/cli/navigate_list.o: cli/navigate_list.c \
 cli/navigate_list.h include/brdf/status.h lib/brdflab/open.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdf/merl.h
cli/navigate_list.h:
include/brdf/status.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
