/tmp/w3_cli/build-asan/obj/cli/navigate_print.o: cli/navigate_print.c \
 cli/navigate_print.h lib/brdflab/basis.h include/brdf/merl.h \
 include/brdf/status.h lib/brdflab/trait.h cli/navigate_list.h \
 include/brdf/status.h cli/say.h
cli/navigate_print.h:
lib/brdflab/basis.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/trait.h:
cli/navigate_list.h:
include/brdf/status.h:
cli/say.h:
