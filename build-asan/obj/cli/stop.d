/tmp/w3_cli/build-asan/obj/cli/stop.o: cli/stop.c cli/stop.h
cli/stop.h:
