/tmp/w3_cli/build-asan/obj/cli/render.o: cli/render.c cli/render.h \
 include/brdfcl/render.h include/brdf/status.h include/brdfcl/api.h \
 include/brdfcl/device.h include/brdfcl/image.h include/brdfcl/scene.h \
 cli/backend.h cli/options.h cli/parse.h include/brdf/vec.h \
 include/brdf/dialect.h cli/commands.h cli/progress.h cli/say.h \
 cli/stop.h
cli/render.h:
include/brdfcl/render.h:
include/brdf/status.h:
include/brdfcl/api.h:
include/brdfcl/device.h:
include/brdfcl/image.h:
include/brdfcl/scene.h:
cli/backend.h:
cli/options.h:
cli/parse.h:
include/brdf/vec.h:
include/brdf/dialect.h:
cli/commands.h:
cli/progress.h:
cli/say.h:
cli/stop.h:
