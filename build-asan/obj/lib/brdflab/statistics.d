/tmp/w3_cli/build-asan/obj/lib/brdflab/statistics.o: \
 lib/brdflab/statistics.c lib/brdflab/statistics.h
lib/brdflab/statistics.h:
