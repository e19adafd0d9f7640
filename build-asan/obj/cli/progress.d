/tmp/w3_cli/build-asan/obj/cli/progress.o: cli/progress.c cli/progress.h \
 include/brdfcl/render.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h include/brdfcl/image.h include/brdfcl/scene.h
cli/progress.h:
include/brdfcl/render.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
include/brdfcl/image.h:
include/brdfcl/scene.h:
