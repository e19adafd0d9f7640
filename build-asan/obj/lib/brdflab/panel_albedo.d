/tmp/w3_cli/build-asan/obj/lib/brdflab/panel_albedo.o: \
 lib/brdflab/panel_albedo.c lib/brdflab/albedo.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h lib/brdflab/plot_panels.h lib/brdflab/plot.h \
 lib/brdflab/section.h lib/brdflab/plot_canvas.h lib/brdflab/curve.h \
 include/brdf/status.h lib/brdflab/plot_scale.h
lib/brdflab/albedo.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
lib/brdflab/plot_panels.h:
lib/brdflab/plot.h:
lib/brdflab/section.h:
lib/brdflab/plot_canvas.h:
lib/brdflab/curve.h:
include/brdf/status.h:
lib/brdflab/plot_scale.h:
