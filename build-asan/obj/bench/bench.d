/tmp/w3_cli/build-asan/obj/bench/bench.o: bench/bench.c bench/bench.h \
 include/brdfcl/device.h include/brdf/status.h include/brdfcl/api.h \
 cli/json.h cli/options.h include/brdf/info.h include/brdf/parameters.h \
 include/brdf/choices.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/material.h include/brdf/sample.h \
 cli/commands.h cli/say.h cli/text_file.h
bench/bench.h:
include/brdfcl/device.h:
include/brdf/status.h:
include/brdfcl/api.h:
cli/json.h:
cli/options.h:
include/brdf/info.h:
include/brdf/parameters.h:
include/brdf/choices.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/material.h:
include/brdf/sample.h:
cli/commands.h:
cli/say.h:
cli/text_file.h:
