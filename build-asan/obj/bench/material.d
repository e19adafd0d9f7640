/tmp/w3_cli/build-asan/obj/bench/material.o: bench/material.c \
 bench/arrays.h include/brdf/material.h include/brdf/sample.h \
 include/brdf/vec.h include/brdf/dialect.h include/brdf/status.h \
 include/brdfcl/evaluate.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h bench/bench.h cli/json.h cli/options.h
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
bench/bench.h:
cli/json.h:
cli/options.h:
