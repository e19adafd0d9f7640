/tmp/w3_cli/build-asan/obj/cli/devices.o: cli/devices.c \
 include/brdfcl/device.h include/brdf/status.h include/brdfcl/api.h \
 cli/commands.h cli/options.h cli/say.h
include/brdfcl/device.h:
include/brdf/status.h:
include/brdfcl/api.h:
cli/commands.h:
cli/options.h:
cli/say.h:
