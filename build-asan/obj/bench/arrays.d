/tmp/w3_cli/build-asan/obj/bench/arrays.o: bench/arrays.c bench/arrays.h \
 include/brdf/material.h include/brdf/sample.h include/brdf/vec.h \
 include/brdf/dialect.h include/brdf/status.h include/brdfcl/evaluate.h \
 include/brdf/status.h include/brdfcl/api.h include/brdfcl/device.h \
 cli/random.h
bench/arrays.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdfcl/evaluate.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
cli/random.h:
