/tmp/w3_cli/build-asan/obj/bench/scene.o: bench/scene.c \
 include/brdfcl/render.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h include/brdfcl/image.h include/brdfcl/scene.h \
 bench/bench.h cli/json.h cli/options.h
include/brdfcl/render.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
include/brdfcl/image.h:
include/brdfcl/scene.h:
bench/bench.h:
cli/json.h:
cli/options.h:
