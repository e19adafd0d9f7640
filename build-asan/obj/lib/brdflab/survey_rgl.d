/tmp/w3_cli/build-asan/obj/lib/brdflab/survey_rgl.o: \
 lib/brdflab/survey_rgl.c lib/brdflab/survey.h include/brdf/material.h \
 include/brdf/sample.h include/brdf/vec.h include/brdf/dialect.h \
 include/brdf/status.h include/brdf/merl.h include/brdf/rgl.h \
 lib/brdflab/lattice.h include/brdf/vec.h
lib/brdflab/survey.h:
include/brdf/material.h:
include/brdf/sample.h:
include/brdf/vec.h:
include/brdf/dialect.h:
include/brdf/status.h:
include/brdf/merl.h:
include/brdf/rgl.h:
lib/brdflab/lattice.h:
include/brdf/vec.h:
