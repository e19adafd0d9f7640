# brdfcl: two libraries, one command. `make` alone prints what there is to make.
#
# Everything that is made lands under $(BUILD). Sources are found by wildcard: a new .c file in
# lib/, cli/, bench/, tests/ or examples/ is built without a word here.

VERSION = 0.1.0
SOVERSION = 0

BUILD = build
PREFIX = /usr/local
DESTDIR =
CC = cc
AR = ar
AWK = awk
PKG_CONFIG = pkg-config
CLANG_FORMAT = clang-format
FUZZ_SECONDS = 600
JOBS = $(shell nproc 2>/dev/null || echo 1)

# CFLAGS, CPPFLAGS and LDFLAGS are yours to replace; what the answers depend on comes after them.
# WERROR= builds on where a compiler newer than ours has found a new warning.
CFLAGS = -O3
WERROR = -Werror
STANDARD = -std=c99 -pedantic-errors
WARNINGS = -Wall -Wextra -Wconversion -Wdouble-promotion $(WERROR)
MATHS = -ffp-contract=off -fno-math-errno -fno-fast-math
CODE = -fvisibility=hidden -fPIC -pthread
SANITIZE =
ALL_CFLAGS = $(CFLAGS) $(STANDARD) $(WARNINGS) $(MATHS) $(CODE) $(SANITIZE)
ALL_LDFLAGS = $(LDFLAGS) $(SANITIZE) -pthread

.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.SUFFIXES:
MAKEFLAGS += --no-builtin-rules

# --- Sources -----------------------------------------------------------------------------------

shared_headers := $(sort $(wildcard include/brdf/*.h include/brdf/*/*.h))
public_headers := $(shared_headers) $(sort $(wildcard include/brdfcl/*.h))
kernel_texts := $(sort $(wildcard kernels/*.h kernels/*.cl))
c_sources := $(sort $(wildcard lib/*/*.c cli/*.c bench/*.c tests/*.c examples/*.c))
c_headers := $(public_headers) $(sort $(wildcard lib/*/*.h cli/*.h bench/*.h tests/*.h kernels/*.h))

test_sources := $(sort $(wildcard tests/test_*.c))
support_sources := $(filter-out $(test_sources),$(sort $(wildcard tests/*.c)))
objects = $(patsubst %.c,$(BUILD)/obj/%.o,$(1))

brdf_objects := $(call objects,$(sort $(wildcard lib/brdf/*.c))) $(BUILD)/obj/embedded_brdf.o
brdfcl_objects := $(call objects,$(sort $(wildcard lib/brdfcl/*.c))) $(BUILD)/obj/embedded_kernels.o
brdflab_objects := $(call objects,$(sort $(wildcard lib/brdflab/*.c)))
command_objects := $(call objects,$(sort $(wildcard cli/*.c bench/*.c)))
support_objects := $(call objects,$(support_sources))
test_programs := $(patsubst tests/%.c,$(BUILD)/tests/%,$(test_sources))
test_scripts := $(sort $(wildcard tests/*.sh))
example_programs := $(patsubst examples/%.c,$(BUILD)/examples/%,$(sort $(wildcard examples/*.c)))

static_brdf := $(BUILD)/libbrdf.a
static_brdfcl := $(BUILD)/libbrdfcl.a
static_brdflab := $(BUILD)/libbrdflab.a
shared_brdf := $(BUILD)/libbrdf.so.$(VERSION)
shared_brdfcl := $(BUILD)/libbrdfcl.so.$(VERSION)
command := $(BUILD)/brdfcl

# --- What libbrdfcl and the laboratory are made with -------------------------------------------

# Asked once, and only when something that needs the answer is built: `make help` and the set-up
# must work on a machine that has no pkg-config yet.
packages = OpenCL OpenEXR libpng assimp expat
ask = $(shell $(PKG_CONFIG) $(1) || echo FAILED)
answer = $(if $(filter FAILED,$(1)),$(error a package is missing: run `make setup`),$(1))
once = $(eval $(1) := $(2))$($(1))

# Their headers are theirs: -isystem keeps our warnings out of them.
package_cflags = $(call once,package_cflags,$(patsubst -I%,-isystem %,$(call \
    answer,$(call ask,--cflags $(packages)))))
# Of OpenEXR the C core, and the library whose C interface reads what the core cannot; of Embree
# (which has no .pc file) the version whose header is there.
embree_version = $(call once,embree_version,$(shell echo '__has_include(<embree4/rtcore.h>)' | \
    $(CC) $(CPPFLAGS) -E -P -x c - 2>/dev/null | grep -q 1 && echo 4 || echo 3))
package_libs = $(call once,package_libs,$(call answer,$(call \
    ask,--libs OpenCL libpng assimp expat)) \
    $(filter -L% -lOpenEXR -lOpenEXR-% -lOpenEXRCore%,$(call ask,--libs OpenEXR)) \
    -lembree$(embree_version) -lm)
embree_cppflags = $(if $(filter 4,$(embree_version)),-DBRDFCL_EMBREE4)
lab_packages = nlopt lapacke lapack cairo
lab_cflags = $(call once,lab_cflags,$(patsubst -I%,-isystem %,$(call \
    answer,$(call ask,--cflags $(lab_packages)))))
lab_libs = $(call once,lab_libs,$(call answer,$(call ask,--libs $(lab_packages))))
cmocka_cflags = $(call once,cmocka_cflags,$(patsubst -I%,-isystem %,$(call \
    answer,$(call ask,--cflags cmocka))))
cmocka_libs = $(call once,cmocka_libs,$(call answer,$(call ask,--libs cmocka)))

# --- Targets for people ------------------------------------------------------------------------

# -j for those who did not say it; a make that was told how many jobs to run keeps to that.
again = $(MAKE) --no-print-directory $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(JOBS))

.PHONY: help
help: ## print this list
	@echo "make TARGET, one of"
	@$(AWK) -F ':.*## ' '/^[a-z-]+:.*## / { printf "  %-16s %s\n", $$1, $$2 }' Makefile
	@echo "BUILD=$(BUILD) PREFIX=$(PREFIX) CC=$(CC) CFLAGS=\"$(CFLAGS)\" WERROR=$(WERROR) JOBS=$(JOBS)"

.PHONY: demo
demo: ## render scenes/demo.xml; installs missing Debian packages first
	@tools/setup.sh
	@$(again) run-demo

.PHONY: test
test: ## run every test; installs missing Debian packages first
	@tools/setup.sh
	@$(again) run-tests

.PHONY: check-full
check-full: ## the tests of the models at full size: a million samples, every variant at all lanes; long
	@tools/setup.sh
	@$(again) run-full

.PHONY: setup
setup: ## only install the Debian packages that are missing
	@tools/setup.sh

.PHONY: all
all: lib cli ## both libraries (static and shared) and the command

.PHONY: lib
lib: $(static_brdf) $(static_brdfcl) $(shared_brdf) $(shared_brdfcl) ## the libraries

.PHONY: cli
cli: $(command) ## the command, build/brdfcl

.PHONY: examples
examples: $(example_programs) ## the embedding examples, in build/examples

.PHONY: tests
tests: $(test_programs) ## build the tests, run none

.PHONY: asan
asan: ## the tests once more under the address and undefined-behaviour sanitizers
	@# What the sanitizers put into the code makes gcc warn of paths that do not exist.
	@$(again) run-tests BUILD=$(BUILD)/asan CFLAGS="-O1 -g" WERROR= \
	    SANITIZE="-fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer"

.PHONY: clang
clang: ## build everything with clang as well, warnings as errors
	@$(again) all tests examples BUILD=$(BUILD)/clang CC=clang

.PHONY: fuzz
fuzz: ## feed the readers of measured files with damaged ones, FUZZ_SECONDS each; needs clang
	@BUILD=$(BUILD) SECONDS_EACH=$(FUZZ_SECONDS) tools/fuzz.sh

.PHONY: bench
bench: cli ## scalar C against OpenCL at every lane count
	$(command) bench

.PHONY: bench-peers
bench-peers: cli ## the same scenes in Mitsuba 3, installed under build/, in turns with ours
	BRDFCL=$(command) BUILD=$(BUILD) bench/peers.sh

.PHONY: bench-measured
bench-measured: cli lib ## evaluate and sample a measured file in Mitsuba 3 and in ours, in turns
	BRDFCL=$(command) BUILD=$(BUILD) SCRIPT=peers_material.py bench/peers.sh

.PHONY: gallery
gallery: cli ## render the figures of scenes/gallery into build/gallery
	@BRDFCL=$(abspath $(command)) tools/make_gallery.sh $(BUILD)/gallery

.PHONY: docs
docs: cli ## render the pictures of docs/models, and write its index
	@BRDFCL=$(abspath $(command)) tools/make_docs.sh

.PHONY: compare-mitsuba
compare-mitsuba: cli ## f, pdf and albedo of every model that Mitsuba 3 has too, value by value
	BRDFCL=$(command) BUILD=$(BUILD) SCRIPT=compare.py bench/peers.sh

.PHONY: run-demo
run-demo: cli
	@$(command) render scenes/demo.xml -o $(BUILD)/demo.png -o $(BUILD)/demo.exr
	@echo "The picture is $(abspath $(BUILD)/demo.png); its linear pixels are in $(BUILD)/demo.exr"

.PHONY: run-tests
run-tests: all $(test_programs) $(example_programs)
	@BUILD=$(BUILD) CC="$(CC)" SANITIZE="$(SANITIZE)" MAKE="$(MAKE)" JOBS="$(JOBS)" \
	    tools/run_tests.sh $(test_scripts) $(test_programs) $(example_programs)

# Each program may take hours here.
.PHONY: run-full
run-full: $(filter $(BUILD)/tests/test_models_%,$(test_programs))
	@BUILD=$(BUILD) JOBS="$(JOBS)" LIMIT=36000 BRDFCL_TEST_LONG=1 tools/run_tests.sh $^

# --- Building ----------------------------------------------------------------------------------

# Who may see whose headers: arrows point down, cli -> laboratory -> libbrdfcl -> libbrdf.
$(BUILD)/obj/lib/brdf/%.o: includes = -Ilib -Ilib/brdf
$(BUILD)/obj/lib/brdfcl/%.o: includes = -I. -Ilib -Ilib/brdfcl -Ikernels $(package_cflags) $(embree_cppflags)
$(BUILD)/obj/lib/brdflab/%.o: includes = -Ilib -Ilib/brdflab $(lab_cflags)
$(BUILD)/obj/cli/%.o: includes = -Icli -Ibench -Ilib
$(BUILD)/obj/bench/%.o: includes = -Ibench -Icli -Ilib
$(BUILD)/obj/tests/%.o: includes = -I. -Itests -Ilib -Ilib/brdf -Ilib/brdfcl -Ilib/brdflab -Ikernels \
    $(cmocka_cflags) $(package_cflags) $(lab_cflags) $(embree_cppflags)

compile = @mkdir -p $(@D) && echo "  cc      $<" && $(CC) -Iinclude $(includes) $(CPPFLAGS) \
    -DBRDFCL_VERSION='"$(VERSION)"' $(ALL_CFLAGS) -MMD -MP -c $< -o $@

$(BUILD)/obj/%.o: %.c
	$(compile)

$(BUILD)/obj/embedded_brdf.o: $(BUILD)/embedded_brdf.c
	$(compile)

$(BUILD)/obj/embedded_kernels.o: $(BUILD)/embedded_kernels.c
	$(compile)

# The text of the shared headers and of the kernels, inside the libraries. The list of names is there
# to notice a file that went away.
$(BUILD)/embedded.list: FORCE
	@mkdir -p $(@D)
	@echo $(shared_headers) $(kernel_texts) | cmp -s - $@ || \
	    echo $(shared_headers) $(kernel_texts) > $@
FORCE:

$(BUILD)/embedded_brdf.c: tools/embed.awk $(BUILD)/embedded.list $(shared_headers)
	@$(AWK) -v table=brdf_embedded_files -v header=lib/brdf/embedded.h -v strip=include/ \
	    -f tools/embed.awk $(shared_headers) < /dev/null > $@

$(BUILD)/embedded_kernels.c: tools/embed.awk $(BUILD)/embedded.list $(kernel_texts)
	@$(AWK) -v table=brdfcl_embedded_files -v header=lib/brdfcl/embedded.h \
	    -f tools/embed.awk $(kernel_texts) < /dev/null > $@

$(BUILD)/obj/embedded_brdf.o $(BUILD)/obj/embedded_kernels.o: includes = -I.

archive = @echo "  ar      $@" && rm -f $@ && $(AR) rcs $@ $(filter %.o,$^)
link = @mkdir -p $(@D) && echo "  link    $@" && $(CC) $(ALL_LDFLAGS)

$(static_brdf): $(brdf_objects)
	$(archive)

$(static_brdfcl): $(brdfcl_objects)
	$(archive)

# What the command and the tests share beyond the libraries; it is not installed.
$(static_brdflab): $(brdflab_objects)
	$(archive)

# $(1) is the name of the library: its soname, and the links that a linker and a loader look for.
shared = $(link) -shared -Wl,-soname,$(1).so.$(SOVERSION) $(if $(SANITIZE),,-Wl,-z,defs) \
    $(filter %.o,$^) -o $@ $(2) && \
    ln -sf $(@F) $(BUILD)/$(1).so.$(SOVERSION) && ln -sf $(@F) $(BUILD)/$(1).so

$(shared_brdf): $(brdf_objects)
	$(call shared,libbrdf,-lm)

$(shared_brdfcl): $(brdfcl_objects) $(shared_brdf)
	$(call shared,libbrdfcl,-L$(BUILD) -lbrdf $(package_libs))

# Programs take the libraries whole, so that they run from anywhere.
$(command): $(command_objects) $(static_brdflab) $(static_brdfcl) $(static_brdf)
	$(link) $^ -o $@ $(lab_libs) $(package_libs)

$(BUILD)/tests/libsupport.a: $(support_objects)
	@mkdir -p $(@D)
	$(archive)

$(test_programs): $(BUILD)/tests/%: $(BUILD)/obj/tests/%.o $(BUILD)/tests/libsupport.a \
    $(static_brdflab) $(static_brdfcl) $(static_brdf)
	$(link) -Wl,--as-needed $^ -o $@ $(cmocka_libs) $(lab_libs) $(package_libs)

$(example_programs): $(BUILD)/examples/%: $(BUILD)/obj/examples/%.o $(static_brdfcl) $(static_brdf)
	$(link) -Wl,--as-needed $^ -o $@ $(package_libs)

-include $(patsubst %.o,%.d,$(brdf_objects) $(brdfcl_objects) \
    $(brdflab_objects) $(command_objects) $(support_objects) $(call objects,$(test_sources)) \
    $(patsubst $(BUILD)/examples/%,$(BUILD)/obj/examples/%.o,$(example_programs)))
.SECONDARY: # keep the objects of tests and examples

# --- Installing --------------------------------------------------------------------------------

bindir = $(PREFIX)/bin
libdir = $(PREFIX)/lib
includedir = $(PREFIX)/include
mandir = $(PREFIX)/share/man
pc = sed -e 's|@prefix@|$(PREFIX)|' -e 's|@version@|$(VERSION)|' -e 's|@private@|$(2)|' \
    lib/$(1)/$(1).pc.in > $(DESTDIR)$(libdir)/pkgconfig/$(1).pc
put_library = install -m 644 $(BUILD)/$(1).a $(DESTDIR)$(libdir)/$(1).a && \
    install -m 755 $(BUILD)/$(1).so.$(VERSION) $(DESTDIR)$(libdir)/$(1).so.$(VERSION) && \
    ln -sf $(1).so.$(VERSION) $(DESTDIR)$(libdir)/$(1).so.$(SOVERSION) && \
    ln -sf $(1).so.$(VERSION) $(DESTDIR)$(libdir)/$(1).so

.PHONY: install
install: all ## headers, libraries, pkg-config files, command and man page, under PREFIX
	install -d $(DESTDIR)$(bindir) $(DESTDIR)$(libdir)/pkgconfig $(DESTDIR)$(mandir)/man1
	install -m 755 $(command) $(DESTDIR)$(bindir)/brdfcl
	install -m 644 docs/brdfcl.1 $(DESTDIR)$(mandir)/man1/brdfcl.1
	@for header in $(public_headers); do \
	    install -D -m 644 $$header "$(DESTDIR)$(PREFIX)/$$header" || exit 1; done
	$(call put_library,libbrdf)
	$(call put_library,libbrdfcl)
	$(call pc,brdf)
	$(call pc,brdfcl,$(package_libs) -pthread)
	@[ -n "$(DESTDIR)" ] || ldconfig 2>/dev/null || true

.PHONY: uninstall
uninstall: ## remove what install put there
	rm -f $(DESTDIR)$(bindir)/brdfcl $(DESTDIR)$(mandir)/man1/brdfcl.1
	rm -f $(DESTDIR)$(libdir)/libbrdf.* $(DESTDIR)$(libdir)/libbrdfcl.*
	rm -f $(DESTDIR)$(libdir)/pkgconfig/brdf.pc $(DESTDIR)$(libdir)/pkgconfig/brdfcl.pc
	rm -rf $(DESTDIR)$(includedir)/brdf $(DESTDIR)$(includedir)/brdfcl

# --- Keeping house -----------------------------------------------------------------------------

formatted := $(sort $(c_sources) $(c_headers) $(kernel_texts) $(wildcard tests/fuzz/*.[ch]))

.PHONY: format
format: ## lay out the sources with clang-format
	@$(CLANG_FORMAT) -i $(formatted)

.PHONY: format-check
format-check: ## fail where `make format` would change something
	@$(CLANG_FORMAT) --dry-run --Werror $(formatted)

.PHONY: lint
lint: ## the rules of the dialect that no compiler knows
	@tools/lint.sh

.PHONY: clean
clean: ## remove everything that was built
	rm -rf $(BUILD)
