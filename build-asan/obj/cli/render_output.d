/tmp/w3_cli/build-asan/obj/cli/render_output.o: cli/render_output.c \
 cli/render.h include/brdfcl/render.h include/brdf/status.h \
 include/brdfcl/api.h include/brdfcl/device.h include/brdfcl/image.h \
 include/brdfcl/scene.h cli/backend.h cli/options.h cli/parse.h \
 include/brdf/vec.h include/brdf/dialect.h cli/json.h cli/text_file.h
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
cli/json.h:
cli/text_file.h:
