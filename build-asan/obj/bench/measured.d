/tmp/w3_cli/build-asan/obj/bench/measured.o: bench/measured.c \
 include/brdf/info.h include/brdf/parameters.h include/brdf/choices.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdf/merl.h include/brdf/rgl.h bench/arrays.h \
 include/brdf/material.h include/brdf/sample.h include/brdfcl/evaluate.h \
 include/brdf/status.h include/brdfcl/api.h include/brdfcl/device.h \
 lib/brdflab/open.h
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
include/brdf/rgl.h:
bench/arrays.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdfcl/evaluate.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
lib/brdflab/open.h:
