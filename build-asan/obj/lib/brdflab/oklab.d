/tmp/w3_cli/build-asan/obj/lib/brdflab/oklab.o: lib/brdflab/oklab.c \
 lib/brdflab/oklab.h
lib/brdflab/oklab.h:
