/tmp/w3_cli/build-asan/obj/lib/brdflab/plot_canvas.o: \
 lib/brdflab/plot_canvas.c lib/brdflab/plot_canvas.h lib/brdflab/curve.h \
 include/brdf/status.h
lib/brdflab/plot_canvas.h:
lib/brdflab/curve.h:
include/brdf/status.h:
