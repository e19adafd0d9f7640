/tmp/w3_cli/build-asan/obj/cli/backend.o: cli/backend.c cli/backend.h \
 include/brdfcl/device.h include/brdf/status.h include/brdfcl/api.h \
 cli/options.h cli/say.h
cli/backend.h:
include/brdfcl/device.h:
include/brdf/status.h:
include/brdfcl/api.h:
cli/options.h:
cli/say.h:
