/tmp/w3_cli/build-asan/obj/lib/brdflab/basis_traits.o: \
 lib/brdflab/basis_traits.c lib/brdflab/basis_traits.h \
 lib/brdflab/basis.h include/brdf/merl.h include/brdf/status.h \
 lib/brdflab/trait.h
lib/brdflab/basis_traits.h:
lib/brdflab/basis.h:
include/brdf/merl.h:
include/brdf/status.h:
lib/brdflab/trait.h:
