/tmp/w3_cli/build-asan/obj/bench/contest.o: bench/contest.c bench/bench.h \
 include/brdfcl/device.h include/brdf/status.h include/brdfcl/api.h \
 cli/json.h cli/options.h
bench/bench.h:
include/brdfcl/device.h:
include/brdf/status.h:
include/brdfcl/api.h:
cli/json.h:
cli/options.h:
