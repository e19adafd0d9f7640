/tmp/w3_cli/build-asan/obj/lib/brdflab/plot_scale.o: \
 lib/brdflab/plot_scale.c lib/brdflab/plot_scale.h
lib/brdflab/plot_scale.h:
