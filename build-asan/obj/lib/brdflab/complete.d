/tmp/w3_cli/build-asan/obj/lib/brdflab/complete.o: lib/brdflab/complete.c \
 lib/brdflab/complete.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/bins.h lib/brdflab/open.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h
lib/brdflab/complete.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/bins.h:
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
