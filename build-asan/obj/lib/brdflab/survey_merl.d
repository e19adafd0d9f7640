/tmp/w3_cli/build-asan/obj/lib/brdflab/survey_merl.o: \
 lib/brdflab/survey_merl.c lib/brdflab/survey.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/merl.h include/brdf/rgl.h \
 lib/brdflab/bins.h
lib/brdflab/survey.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
include/brdf/rgl.h:
lib/brdflab/bins.h:
