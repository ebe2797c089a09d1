# SPDX-License-Identifier: MIT
# Pantin. `make demo` and `make test` do everything on a fresh Debian 12, set-up included.
#   config=release|debug|sanitize   objects and programs go to build/$(config)/
#   GLPK=0 WEBP=0 GIF=0 YAML=0 PUGIXML=0 CGAL=0   build without that library; =1: stop when it is not there
#   WEIGHTS=0 EXPLAIN=0 MODELING=0 VERIFY=0       a smaller program: without that data or command (README, "Small builds")
#   STATIC=1                        one static binary, build/release-static/pantin
#   werror=1                        warnings are errors (CI);    CXX=clang++  another compiler
#   CPPFLAGS= CXXFLAGS= LDFLAGS= LDLIBS=   are added to ours
#   V=1                             shows the commands
# What depends on a switch is made again when it changes; nothing asks for `make clean`.

config ?= release
BUILD ?= build/$(config)$(if $(filter 1,$(STATIC)),-static)
PREFIX ?= /usr/local
DESTDIR ?=
INSTALL ?= install
AR ?= ar
VERSION := $(shell sed -n 's/^.define PANTIN_VERSION_[MP][A-Z]* //p' include/pantin/version.hpp | paste -sd.)

# `$(call run,WORD)` opens a command line: shows WORD and the target, or with V=1 the command. The first one says before which
# libraries are in.
run = $(say_libraries)$(if $(filter 1,$(V)),,@printf '  %-4s %s\n' $(1) $@;)

# --- optional libraries ----------------------------------------------------------------------------------------------------------
# Each has a folder in each module that uses it. All code that touches the library is in there, beside absent.cpp, which defines the
# same functions for a build without it. One or the other is compiled: no macro, no other place. Callers ask X_available().
comma := ,
LIBRARIES := GLPK WEBP GIF YAML PUGIXML CGAL
GLPK_folders := src/identification/glpk
GLPK_header := glpk.h
GLPK_libs := -lglpk
WEBP_folders := src/image/webp src/export/webp
WEBP_header := webp/mux.h
WEBP_libs := -lwebpmux -lwebpdemux -lwebp
GIF_folders := src/export/gif
GIF_header := gif_lib.h
GIF_libs := -lgif
YAML_folders := src/core/yaml
YAML_header := yaml-cpp/yaml.h
YAML_libs := -lyaml-cpp
PUGIXML_folders := src/modeling/pugixml
PUGIXML_header := pugixml.hpp
PUGIXML_libs := -lpugixml
# Only tests compare with CGAL: the program never contains it, nothing installs it, and instrumenting it tells nothing.
CGAL_folders := tests/modeling/cgal
CGAL_header := CGAL/version.h
CGAL_libs := -lmpfr -lgmp
ifeq ($(config),sanitize)
  CGAL ?= 0
endif
ifeq ($(STATIC),1)
  GLPK_libs += -lamd -lcolamd -lsuitesparseconfig -lgmp -lz
endif

# $(call have,HEADER,LIBRARIES): 1 when both are there, else empty. make 4.3 hands the backslash of an escaped # on to the shell,
# so it goes through a variable; a test (tests/cli/make_test.cpp) proves that the answer can be no.
hash := \#
have = $(shell { printf '$(hash)if !__has_include(<$(1)>)\n$(hash)error\n$(hash)endif\nint main() {}\n' | \
    $(CXX) $(CPPFLAGS) -x c++ - $(LDFLAGS) $(if $(filter 1,$(STATIC)),-static) $(2) -o /dev/null && echo 1; } 2>/dev/null)
# Set by the user or found; what the user wants and is not there is said by the first command that needs it.
define detect
ifeq ($(strip $($(1))),)
  override $(1) := $(if $(call have,$($(1)_header),$($(1)_libs)),1,0)
else ifneq ($(filter-out 0 1,$($(1))),)
  $$(error $(1) must be 0 or 1, not '$($(1))')
else ifeq ($($(1)),1)
  $(1)_missing := $(if $(call have,$($(1)_header),$($(1)_libs)),,$(1))
endif
endef
switches := $(foreach library,$(LIBRARIES),$(library)=$($(library)))

# --- what a small program leaves out ---------------------------------------------------------------------------------------------
# Commands in the same way, with what is compiled in for them. The library stays whole; what no command calls is not linked.
FEATURES := WEIGHTS EXPLAIN MODELING VERIFY
EXPLAIN_folders := src/cli/explain
MODELING_folders := src/cli/model
VERIFY_folders := src/cli/verify
$(foreach feature,$(FEATURES),$(eval $(feature) ?= 1)$(if $(filter-out 0 1,$($(feature))),$(error $(feature) must be 0 or 1, not '$($(feature))')))
without := $(strip $(foreach feature,$(FEATURES),$(if $(filter 0,$($(feature))),$(feature)=0)))
ifneq ($(filter-out demo test sanitize deps clean uninstall format check-format,$(or $(MAKECMDGOALS),all)),)
  $(foreach library,$(LIBRARIES),$(eval $(call detect,$(library))))
endif
with = $(strip $(foreach library,$(LIBRARIES),$(if $(filter $(1),$($(library))),$(library))))
libraries_line = optional libraries: $(or $(call with,1),none)$(if $(call with,0),; without $(call with,0))
complain = $(error $(1)=1, but <$($(1)_header)> or $($(1)_libs) is not installed (tools/install_deps.sh names the package))
say_libraries = $(foreach library,$(LIBRARIES),$(foreach name,$($(library)_missing),$(call complain,$(name))))$(info $(libraries_line))$(eval say_libraries :=)

# --- flags -----------------------------------------------------------------------------------------------------------------------
cppflags := -Iinclude -Isrc -Itools -isystem /usr/include/eigen3 -DEIGEN_DONT_VECTORIZE -DEIGEN_DONT_PARALLELIZE -DEIGEN_MPL2_ONLY
cxxflags := -std=c++20 -Wall -Wextra -ffile-prefix-map=$(CURDIR)=. -pthread
ldflags := -pthread
# Determinism: no contraction of a*b+c, no fast-math, on any compiler, after whatever flags a user adds (docs/determinism.md).
exact := -ffp-contract=off -fno-fast-math

ifeq ($(config),release)
  cxxflags += -O2
else ifeq ($(config),debug)
  cxxflags += -O0 -g
else ifeq ($(config),sanitize)
  # g++ 12 reports false maybe-uninitialized reads in <regex> once the sanitizers are on.
  cxxflags += -Wno-unknown-warning-option -Wno-maybe-uninitialized
  # Line tables are all that the reports need; full debug information doubles the time to compile.
  cxxflags += -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
  ldflags += -fsanitize=address,undefined
else
  $(error config must be release, debug or sanitize, not '$(config)')
endif
ifeq ($(werror),1)
  cxxflags += -Werror
endif
ifeq ($(STATIC),1)
  ldflags += -static $(if $(filter 1,$(GLPK)),-Wl$(comma)-u$(comma)lt_dlinit)
endif
libs := $(foreach library,$(filter-out CGAL,$(call with,1)),$($(library)_libs))
compile = $(CXX) $(cppflags) $(CPPFLAGS) $(cxxflags) $(CXXFLAGS) $(exact)
link = $(CXX) $(ldflags) $(LDFLAGS) -o $@ $(filter %.o %.a,$^)

# Tests take longer to compile than to run, but for those that compute what they check; so does what calls the steps and reads
# and writes files, once it is instrumented. Where films and networks spend their time the sanitizers pay off optimised.
computing_tests := geometry identification modeling network replay skeletonization
glue := cli/% evaluation/% formats/% pipeline/% modeling/pugixml/% modeling/strokes_% modeling/svg_%
hot := animation/rasteriser animation/film_texture network/kernel_% network/integer/kernel_%
# Loops over pixels and weights, which vectors make a fifth faster.
pixel_loops := image/% network/% segmentation/% detection/% geometry/borders skeletonization/thinning
objects = $(patsubst %,$(BUILD)/src/%.o,$(1))
$(BUILD)/tests/%.o: cppflags += -Itests
$(BUILD)/tests/%.o: cxxflags += -O0
ifeq ($(config),release)
# (There g++ 12 reports false overlaps of joined strings: its bug 105651.)
$(call objects,$(pixel_loops)): cxxflags += -O3 -Wno-unknown-warning-option -Wno-restrict
$(foreach module,$(computing_tests),$(BUILD)/tests/$(module)/%.o): cxxflags += -O1
else ifeq ($(config),sanitize)
$(call objects,$(glue)): cxxflags += -O0
$(call objects,$(hot)): cxxflags += -O2
$(BUILD)/tests/main.o: cxxflags += -fno-sanitize=all # Catch2 alone
endif
# A damaged JPEG makes stb_image's inverse transform overflow: defined, as two's complement.
$(BUILD)/src/image/load.o: cxxflags += -fwrapv
# CGAL's interval arithmetic changes the rounding mode; g++ 12 reports false maybe-uninitialized reads in its headers.
$(BUILD)/tests/modeling/cgal/%.o: cxxflags += -O1 -frounding-math -Wno-unknown-warning-option -Wno-maybe-uninitialized

# --- sources ---------------------------------------------------------------------------------------------------------------------
left_out := $(foreach name,$(LIBRARIES) $(FEATURES),$(addsuffix /$(if $(filter 1,$($(name))),absent.cpp,%),$($(name)_folders)))
left_out += $(if $(filter 1,$(STATIC)),,src/core/static_program/%)
absent := $(foreach name,$(call with,0) $(subst =0,,$(without)),$(addsuffix /absent.cpp,$($(name)_folders)))
# $(call objects_of,FOLDERS): of all their sources, but for main.cpp
objects_of = $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out %/main.cpp,$(filter-out $(left_out),$(sort $(wildcard \
    $(foreach folder,$(1),$(folder)/*.cpp $(folder)/*/*.cpp $(folder)/*/*/*.cpp)))) $(filter $(addsuffix /%,$(1)),$(absent))))
LIB_OBJECTS := $(call objects_of,src) $(BUILD)/resources.o
DOODLE_OBJECTS := $(call objects_of,tools/doodle)
TORCH_OBJECTS := $(call objects_of,tools/compare_torch)
FIGURE_OBJECTS := $(call objects_of,tools/figures) $(BUILD)/tools/bench/timing.o
TEST_OBJECTS := $(call objects_of,tests) $(BUILD)/tests/main.o $(BUILD)/tools/bench/sample_renderer.o
BENCH_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tools/bench/*.cpp))
COMPARE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tools/compare/*.cpp))
EVALUATE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(wildcard tools/identification/*.cpp))
RESOURCES := $(sort $(wildcard references/*.json $(if $(filter 1,$(WEIGHTS)),weights/*.safetensors) \
    $(if $(filter 1,$(EXPLAIN)),src/explain/assets/*.* src/explain/assets/*/*.*)))
ARCHIVES := $(if $(filter 1,$(VERIFY)),vectors.tar.gz)
VECTORS := $(sort $(shell find testdata/vectors)) # folders, too, so that a file that goes away counts
# The folder $(2) of $(1) as an archive whose bytes depend on its files alone.
pack = tar -C $(1) --format=ustar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX -cf - $(2) | gzip -9 -n

.PHONY: all FORCE whole demo demo-run test test-run sanitize deps doodle libraries bench figures results verify update-verify verify-arm64 \
    vectors vectors-files test-web check-gltf install install-files uninstall clean format check-format tidy compile_commands.json
all: $(BUILD)/pantin

# Set-up happens in a first make, so that the second one sees the libraries that were just installed. The second one uses
# all cores unless -j was given. `make -j demo test` does one after the other: both build the same files.
jobs = $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(shell nproc 2>/dev/null || echo 2))
ifneq ($(filter demo test sanitize,$(MAKECMDGOALS)),)
.NOTPARALLEL:
endif
demo: deps
	@$(MAKE) $(jobs) --no-print-directory demo-run
test: deps
	@$(MAKE) $(jobs) --no-print-directory test-run
deps:
	@$(switches) CXX='$(CXX)' tools/install_deps.sh

# Which optional libraries this machine has, as a build would take them.
libraries:
	$(say_libraries)@:

demo-run: $(BUILD)/pantin
	$(BUILD)/pantin animate testdata/demo.png -o out/demo

# The tests are about the whole program, several files of them at a time.
test-run: $(if $(without),whole,$(BUILD)/pantin-tests $(BUILD)/pantin $(BUILD)/doodle)
	PANTIN=$(BUILD)/pantin DOODLE=$(BUILD)/doodle $(BUILD)/pantin-tests --jobs $(TEST_JOBS) $(TEST_ARGS)
TEST_JOBS ?= $(shell nproc 2>/dev/null || echo 2)
whole:
	$(error the tests need the whole program, not one made with $(without))

sanitize:
	@$(MAKE) --no-print-directory config=sanitize test

bench: $(BUILD)/bench
	$(BUILD)/bench

# The pictures of docs/figures, from testdata/ alone: the same bytes every time.
figures: $(BUILD)/figures
	$(BUILD)/figures docs/figures

# docs/results.md: times, which differ from run to run, and the success of each step on 30 generated drawings (a few minutes).
results: $(BUILD)/figures $(BUILD)/doodle
	rm -rf out/results
	$(BUILD)/doodle out/results/drawings --seed 2026 --count 30 --type mixed --size 640 --height 480
	$(BUILD)/figures results docs/results.md out/results/drawings out/results docs/verdicts.csv

doodle: $(BUILD)/doodle

# Every stage against the stored results; `update-verify` stores them anew after a change that is meant to change them.
verify: $(BUILD)/pantin
	$(BUILD)/pantin verify
update-verify: $(BUILD)/pantin
	$(BUILD)/pantin verify --end-to-end --quiet -o testdata/vectors || [ $$? = 8 ]
	@$(MAKE) --no-print-directory verify
# The same on aarch64, emulated. Debian: crossbuild-essential-arm64 qemu-user-static.
verify-arm64:
	@$(MAKE) $(jobs) --no-print-directory CXX=aarch64-linux-gnu-g++ AR=aarch64-linux-gnu-ar BUILD=build/arm64 STATIC=1 \
	    GLPK=0 WEBP=0 GIF=0 YAML=0 PUGIXML=0 CGAL=0 build/arm64/pantin
	qemu-aarch64-static build/arm64/pantin verify

# Reference vectors for other implementations (testdata/vectors/README.md) as an archive; the same bytes every time.
vectors_out ?= build/vectors
vectors_name = pantin-vectors-$(VERSION)
vectors: $(BUILD)/pantin vectors-files
vectors-files:
	rm -rf $(vectors_out)/$(vectors_name)
	$(BUILD)/pantin verify --quiet -o $(vectors_out)/$(vectors_name)
	cp -r testdata/vectors/README.md weights references $(vectors_out)/$(vectors_name)/
	rm -r $(vectors_out)/$(vectors_name)/weights/float
	cd $(vectors_out)/$(vectors_name) && find * -type f | LC_ALL=C sort | xargs sha256sum > ../$(vectors_name).sums
	mv $(vectors_out)/$(vectors_name).sums $(vectors_out)/$(vectors_name)/SHA256SUMS
	$(call pack,$(vectors_out),$(vectors_name)) > $(vectors_out)/$(vectors_name).tar.gz

check-gltf: demo
	tools/check_gltf.sh out/demo

# The pages of `explain` in headless Chromium.
test-web: $(BUILD)/pantin
	tools/web/check_page.sh $(BUILD)/pantin out/web

# --- what is made of what --------------------------------------------------------------------------------------------------------
# A stamp is a file that holds its text, and is written anew only when that differs: what depends on it is made again exactly then.
same = $(if $(subst x$(1)x,,x$(2)x),,1)
stamp = $(if $(call same,$(file <$@),$(1)),,$(shell mkdir -p $(@D))$(file >$@,$(1)))@:
# One line stands for all objects: flags of single files follow from this file's rules. (They would be in a prerequisite's recipe, too:
# hence :=.)
compile_line := $(subst $(CURDIR),.,$(compile))
$(BUILD)/compile.stamp: FORCE
	$(call stamp,$(compile_line))
$(BUILD)/libpantin.stamp: FORCE
	$(call stamp,$(AR) $(LIB_OBJECTS))

$(BUILD)/libpantin.a: $(LIB_OBJECTS) $(BUILD)/libpantin.stamp
	@rm -f $@
	$(call run,AR)$(AR) rcsD $@ $(LIB_OBJECTS)

# $(call program,NAME,OBJECTS,LIBRARIES)
define program
$(BUILD)/$(1).stamp: FORCE
	$$(call stamp,$(CXX) $(ldflags) $(LDFLAGS) $(2) $(3) $(libs) $(LDLIBS))
$(BUILD)/$(1): $(2) $(BUILD)/libpantin.a $(BUILD)/$(1).stamp
	$$(call run,LINK)$$(link) $(3) $(libs) $(LDLIBS)
ALL_OBJECTS += $(2)
endef
ALL_OBJECTS := $(LIB_OBJECTS)
$(eval $(call program,pantin,$(BUILD)/src/cli/main.o))
$(eval $(call program,pantin-tests,$(TEST_OBJECTS) $(DOODLE_OBJECTS) $(FIGURE_OBJECTS) $(TORCH_OBJECTS),$(if $(filter 1,$(CGAL)),$(CGAL_libs))))
$(eval $(call program,doodle,$(BUILD)/tools/doodle/main.o $(DOODLE_OBJECTS)))
$(eval $(call program,bench,$(BENCH_OBJECTS) $(DOODLE_OBJECTS)))
$(eval $(call program,figures,$(BUILD)/tools/figures/main.o $(FIGURE_OBJECTS) $(DOODLE_OBJECTS)))
$(eval $(call program,compare_reference,$(COMPARE_OBJECTS)))
$(eval $(call program,compare_torch,$(BUILD)/tools/compare_torch/main.o $(TORCH_OBJECTS)))
$(eval $(call program,evaluate_identification,$(EVALUATE_OBJECTS)))
$(eval $(call program,motion_quality,$(BUILD)/tools/motion_quality/main.o))
ALL_OBJECTS := $(sort $(ALL_OBJECTS))

# Weights and references are compiled in, so that the program is one file that runs anywhere.
$(BUILD)/resources.stamp: FORCE
	$(call stamp,$(RESOURCES) $(ARCHIVES))
$(BUILD)/resources.S: tools/embed.sh $(RESOURCES) $(addprefix $(BUILD)/,$(ARCHIVES)) Makefile $(BUILD)/resources.stamp
	@mkdir -p $(@D)
	$(call run,DATA)tools/embed.sh $(RESOURCES) $(foreach archive,$(ARCHIVES),$(archive)=$(BUILD)/$(archive)) > $@.tmp && mv $@.tmp $@
$(BUILD)/vectors.tar.gz: $(VECTORS) Makefile
	@mkdir -p $(@D)
	$(call run,DATA)$(call pack,testdata,vectors) > $@.tmp && mv $@.tmp $@
$(BUILD)/resources.o: $(BUILD)/resources.S $(BUILD)/compile.stamp
	$(call run,AS)$(CXX) -c -o $@ $<

$(BUILD)/%.o: %.cpp $(BUILD)/compile.stamp
	@mkdir -p $(@D)
	$(call run,CXX)$(compile) -MMD -MP -c -o $@ $<
-include $(ALL_OBJECTS:.o=.d)

# --- the source -------------------------------------------------------------------------------------------------------------------
# How each file is compiled, for editors and clang-tidy.
json = $(subst ",\",$(subst \,\\,$(1)))
entry = {"directory": "$(CURDIR)", "file": "$(1)", "command": "$(call json,$(compile) $(if $(filter tests/%,$(1)),-Itests) -c $(1))"}
compile_commands.json:
	$(file >$@,[)$(foreach object,$(filter-out $(BUILD)/resources.o,$(ALL_OBJECTS)),$(file >>$@,$(call \
	    entry,$(patsubst $(BUILD)/%.o,%.cpp,$(object)))$(if $(filter $(object),$(lastword $(ALL_OBJECTS))),,$(comma))))$(file >>$@,])@:
tidy: compile_commands.json
	find src include tools -name '*.cpp' | LC_ALL=C sort | xargs -P $(shell nproc) -n 1 clang-tidy -p . --quiet

# clang-format of Debian 12 (14); another release formats differently.
CLANG_FORMAT ?= clang-format-14
formatted = find include src tests tools docs -name '*.[ch]pp' -print0 | xargs -0 $(CLANG_FORMAT)
format:
	@tools/install_deps.sh format
	$(formatted) -i
check-format:
	@tools/install_deps.sh format
	$(formatted) --dry-run -Werror

# What stands where: program, library, headers, man pages, completion, pkg-config.
share = $(DESTDIR)$(PREFIX)/share
completions = share/bash-completion/completions/pantin share/zsh/site-functions/_pantin share/fish/vendor_completions.d/pantin.fish
install: $(BUILD)/pantin install-files
install-files:
	$(INSTALL) -d $(DESTDIR)$(PREFIX)/bin $(DESTDIR)$(PREFIX)/lib/pkgconfig $(DESTDIR)$(PREFIX)/include/pantin $(share)/man/man1 \
	    $(foreach file,$(completions),$(DESTDIR)$(PREFIX)/$(dir $(file)))
	$(INSTALL) -m 755 $(BUILD)/pantin $(DESTDIR)$(PREFIX)/bin/pantin
	$(INSTALL) -m 644 $(BUILD)/libpantin.a $(DESTDIR)$(PREFIX)/lib/libpantin.a
	$(INSTALL) -m 644 include/pantin/*.hpp $(DESTDIR)$(PREFIX)/include/pantin/
	printf 'prefix=%s\nName: pantin\nDescription: drawings of characters come alive\nVersion: %s\nCflags: -I$${prefix}/include\nLibs: -L$${prefix}/lib -lpantin -pthread %s\n' \
	    '$(PREFIX)' '$(VERSION)' '$(libs) $(LDLIBS)' > $(DESTDIR)$(PREFIX)/lib/pkgconfig/pantin.pc
	$(BUILD)/pantin manual -o $(share)/man/man1
	$(BUILD)/pantin completion bash > $(DESTDIR)$(PREFIX)/$(word 1,$(completions))
	$(BUILD)/pantin completion zsh > $(DESTDIR)$(PREFIX)/$(word 2,$(completions))
	$(BUILD)/pantin completion fish > $(DESTDIR)$(PREFIX)/$(word 3,$(completions))
uninstall:
	rm -f $(DESTDIR)$(PREFIX)/bin/pantin $(DESTDIR)$(PREFIX)/lib/libpantin.a $(DESTDIR)$(PREFIX)/lib/pkgconfig/pantin.pc
	rm -f $(share)/man/man1/pantin.1 $(share)/man/man1/pantin-*.1 $(addprefix $(DESTDIR)$(PREFIX)/,$(completions))
	rm -rf $(DESTDIR)$(PREFIX)/include/pantin
clean:
	rm -rf build out compile_commands.json
