/tmp/w3_cli/build-asan/obj/lib/brdflab/open.o: lib/brdflab/open.c \
 lib/brdflab/open.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/merl.h include/brdf/info.h include/brdf/parameters.h \
 include/brdf/choices.h lib/brdflab/bake.h include/brdf/rgl.h
lib/brdflab/open.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
lib/brdflab/bake.h:
include/brdf/rgl.h:
