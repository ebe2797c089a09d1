# SPDX-License-Identifier: MIT
# Pantin. `make demo` and `make test` do everything on a fresh Debian 12, set-up included.
#   config=release|debug|sanitize   objects and programs go to build/$(config)/
#   GLPK=0 WEBP=0 GIF=0 YAML=0 PUGIXML=0 CGAL=0   build without that library (the tests need pugixml)
#   STATIC=1                        one static binary, build/release-static/pantin
#   werror=1                        warnings are errors (CI);    CXX=clang++  another compiler
#   V=1                             shows the commands

config ?= release
BUILD ?= build/$(config)$(if $(filter 1,$(STATIC)),-static)
PREFIX ?= /usr/local
DESTDIR ?=
INSTALL ?= install
AR ?= ar
VERSION := 0.1.0
DATE := 2026-11-28# of the man pages

ifeq ($(V),1)
  run =
else
  run = @printf '  %-4s %s\n' $(1) $@;
endif

have = $(shell printf '\#include <stdio.h>\n\#include <$(1)>\n' | $(CXX) -E -x c++ - >/dev/null 2>&1 && echo 1)
have_cxx = $(shell printf '\#include <$(1)>\n' | $(CXX) -E -x c++ - >/dev/null 2>&1 && echo 1)
GLPK ?= $(call have,glpk.h)
WEBP ?= $(call have,webp/mux.h)
GIF ?= $(call have,gif_lib.h)
YAML ?= $(call have_cxx,yaml-cpp/yaml.h)
PUGIXML ?= $(call have_cxx,pugixml.hpp)
# Only tests compare with CGAL: nothing installs it, and instrumenting it tells nothing.
CGAL ?= $(if $(filter sanitize,$(config)),0,$(and $(call have,gmp.h),$(call have_cxx,CGAL/version.h)))

# Determinism: no contraction of a*b+c, no fast-math, on any compiler (docs/determinism.md).
CPPFLAGS += -Iinclude -Isrc -Itools -isystem /usr/include/eigen3 -DPANTIN_VERSION='"$(VERSION)"' \
            -DEIGEN_DONT_VECTORIZE -DEIGEN_DONT_PARALLELIZE -DEIGEN_MPL2_ONLY
CXXFLAGS += -std=c++20 -Wall -Wextra -ffp-contract=off -ffile-prefix-map=$(CURDIR)=. -pthread
LDFLAGS += -pthread
LDLIBS :=

ifeq ($(config),release)
  CXXFLAGS += -O2
else ifeq ($(config),debug)
  CXXFLAGS += -O0 -g
else ifeq ($(config),sanitize)
  # g++ 12 reports false maybe-uninitialized reads in <regex> once the sanitizers are on.
  CXXFLAGS += -Wno-unknown-warning-option -Wno-maybe-uninitialized
  # Line tables are all that the reports need; full debug information doubles the time to compile.
  CXXFLAGS += -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
  LDFLAGS += -fsanitize=address,undefined
else
  $(error config must be release, debug or sanitize, not '$(config)')
endif
ifeq ($(werror),1)
  CXXFLAGS += -Werror
endif
ifeq ($(STATIC),1)
  CPPFLAGS += -DPANTIN_STATIC=1
  LDFLAGS += -static
endif
ifeq ($(GLPK),1)
  CPPFLAGS += -DPANTIN_GLPK=1
  LDLIBS += -lglpk
  ifeq ($(STATIC),1)
    LDLIBS += -lamd -lcolamd -lsuitesparseconfig -lgmp -lz
    LDFLAGS += -Wl,-u,lt_dlinit
  endif
endif
ifeq ($(WEBP),1)
  CPPFLAGS += -DPANTIN_WEBP=1
  LDLIBS += -lwebpmux -lwebpdemux -lwebp
endif
ifeq ($(GIF),1)
  CPPFLAGS += -DPANTIN_GIF=1
  LDLIBS += -lgif
endif

ifeq ($(PUGIXML),1)
  CPPFLAGS += -DPANTIN_PUGIXML=1
  LDLIBS += -lpugixml
endif
ifeq ($(YAML),1)
  CPPFLAGS += -DPANTIN_YAML=1
  LDLIBS += -lyaml-cpp
endif

SOURCES := $(sort $(wildcard src/*/*.cpp src/*/*/*.cpp))
ifeq ($(CGAL),1)
  SOURCES := $(filter-out src/modeling/exact_union_unavailable.cpp,$(SOURCES))
  CGAL_LDLIBS := -lmpfr -lgmp
else
  SOURCES := $(filter-out src/modeling/cgal/%,$(SOURCES))
endif
ifneq ($(GLPK),1)
  SOURCES := $(filter-out src/identification/glpk/%,$(SOURCES))
endif
ifneq ($(PUGIXML),1)
  SOURCES := $(filter-out src/modeling/strokes_svg.cpp,$(SOURCES))
endif
LIB_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out src/cli/main.cpp,$(SOURCES))) $(BUILD)/resources.o
DOODLE_SOURCES := $(sort $(wildcard tools/doodle/*.cpp))
DOODLE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out tools/doodle/main.cpp,$(DOODLE_SOURCES)))
TEST_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard tests/*.cpp tests/*/*.cpp)))
BENCH_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard tools/bench/*.cpp)))
COMPARE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard tools/compare/*.cpp)))
TORCH_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out tools/compare_torch/main.cpp,$(sort $(wildcard tools/compare_torch/*.cpp))))
FIGURE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(filter-out tools/figures/main.cpp,$(sort $(wildcard tools/figures/*.cpp))) tools/bench/timing.cpp)
EVALUATE_OBJECTS := $(patsubst %.cpp,$(BUILD)/%.o,$(sort $(wildcard tools/identification/*.cpp)))
RESOURCES := $(sort $(wildcard weights/*.safetensors references/*.json src/explain/assets/*.* src/explain/assets/*/*.*))
VECTORS := $(sort $(shell find testdata/vectors)) # folders, too, so that a file that goes away counts
# The folder $(2) of $(1) as an archive whose bytes depend on its files alone.
pack = tar -C $(1) --format=ustar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner --mode=u=rwX,go=rX -cf - $(2) | gzip -9 -n

.PHONY: verify update-verify verify-arm64 vectors vectors-files test-web all demo demo-run test test-run sanitize bench figures results install install-files uninstall clean deps doodle check-gltf
all: $(BUILD)/pantin

# Set-up happens in a first make, so that the second one sees the libraries that were just installed. The second one uses
# all cores unless -j was given.
jobs = $(if $(findstring jobserver,$(MAKEFLAGS)),,-j$(shell nproc 2>/dev/null || echo 2))
demo: deps
	@$(MAKE) $(jobs) --no-print-directory demo-run
test: deps
	@$(MAKE) $(jobs) --no-print-directory test-run
deps:
	@tools/install_deps.sh

demo-run: $(BUILD)/pantin
	$(BUILD)/pantin animate testdata/demo.png -o out/demo

test-run: $(BUILD)/pantin-tests $(BUILD)/pantin $(BUILD)/doodle
	PANTIN=$(BUILD)/pantin DOODLE=$(BUILD)/doodle $(BUILD)/pantin-tests $(TEST_ARGS)

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
	cd $(vectors_out)/$(vectors_name) && find * -type f | LC_ALL=C sort | xargs sha256sum > ../$(vectors_name).sums
	mv $(vectors_out)/$(vectors_name).sums $(vectors_out)/$(vectors_name)/SHA256SUMS
	$(call pack,$(vectors_out),$(vectors_name)) > $(vectors_out)/$(vectors_name).tar.gz

check-gltf: demo
	tools/check_gltf.sh out/demo

# The pages of `explain` in headless Chromium.
test-web: $(BUILD)/pantin
	tools/web/check_page.sh $(BUILD)/pantin out/web

$(BUILD)/pantin: $(BUILD)/src/cli/main.o $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(BUILD)/libpantin.a: $(LIB_OBJECTS)
	@rm -f $@
	$(call run,AR)$(AR) rcsD $@ $^
$(BUILD)/doodle: $(BUILD)/tools/doodle/main.o $(DOODLE_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(BUILD)/pantin-tests: $(TEST_OBJECTS) $(DOODLE_OBJECTS) $(FIGURE_OBJECTS) $(TORCH_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS) $(CGAL_LDLIBS)
$(BUILD)/tests/%.o: CPPFLAGS += -Itests
# Tests take longer to compile than to run, but for those that compute what they check; so does what calls the steps and reads
# and writes files, once it is instrumented. Where films and networks spend their time the sanitizers pay off optimised.
computing_tests = geometry identification modeling network skeletonization
glue = cli/% evaluation/% pipeline/% modeling/strokes_% modeling/svg_path
hot = animation/rasteriser network/kernel_%
objects = $(patsubst %,$(BUILD)/src/%.o,$(1))
$(BUILD)/tests/%.o: CXXFLAGS += -O0
ifeq ($(config),release)
$(foreach room,$(computing_tests),$(BUILD)/tests/$(room)/%.o): CXXFLAGS += -O1
endif
$(BUILD)/src/cli/manual.o: CPPFLAGS += -DPANTIN_DATE='"$(DATE)"'
# CGAL's interval arithmetic changes the rounding mode; g++ 12 reports false maybe-uninitialized reads in its headers.
$(BUILD)/src/modeling/cgal/%.o: CXXFLAGS += -O1 -frounding-math -Wno-unknown-warning-option -Wno-maybe-uninitialized
ifeq ($(config),sanitize)
$(call objects,$(glue)): CXXFLAGS += -O0
$(call objects,$(hot)): CXXFLAGS += -O2
$(BUILD)/tests/main.o: CXXFLAGS += -fno-sanitize=all # Catch2 alone
endif
$(BUILD)/bench: $(BENCH_OBJECTS) $(DOODLE_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/figures: $(BUILD)/tools/figures/main.o $(FIGURE_OBJECTS) $(DOODLE_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(BUILD)/compare_reference: $(COMPARE_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(BUILD)/compare_torch: $(BUILD)/tools/compare_torch/main.o $(TORCH_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)
$(BUILD)/evaluate_identification: $(EVALUATE_OBJECTS) $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)

$(BUILD)/motion_quality: $(BUILD)/tools/motion_quality/main.o $(BUILD)/libpantin.a
	$(call run,LINK)$(CXX) $(LDFLAGS) -o $@ $^ $(LDLIBS)

# Weights and references are compiled in, so that the program is one file that runs anywhere.
$(BUILD)/resources.S: tools/embed.sh $(RESOURCES) $(BUILD)/vectors.tar.gz Makefile
	@mkdir -p $(@D)
	$(call run,DATA)tools/embed.sh $(RESOURCES) vectors.tar.gz=$(BUILD)/vectors.tar.gz > $@.tmp && mv $@.tmp $@
$(BUILD)/vectors.tar.gz: $(VECTORS) Makefile
	@mkdir -p $(@D)
	$(call run,DATA)$(call pack,testdata,vectors) > $@.tmp && mv $@.tmp $@
$(BUILD)/resources.o: $(BUILD)/resources.S
	$(call run,AS)$(CXX) -c -o $@ $<

$(BUILD)/%.o: %.cpp
	@mkdir -p $(@D)
	$(call run,CXX)$(CXX) $(CPPFLAGS) $(CXXFLAGS) $(FILE_FLAGS) -MMD -MP -c -o $@ $<
-include $(patsubst %.o,%.d,$(LIB_OBJECTS) $(DOODLE_OBJECTS) $(TEST_OBJECTS) $(BENCH_OBJECTS) $(COMPARE_OBJECTS) $(FIGURE_OBJECTS) $(EVALUATE_OBJECTS) $(TORCH_OBJECTS) $(BUILD)/tools/compare_torch/main.o $(BUILD)/src/cli/main.o $(BUILD)/tools/doodle/main.o $(BUILD)/tools/figures/main.o $(BUILD)/tools/motion_quality/main.o)

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
	    '$(PREFIX)' '$(VERSION)' '$(LDLIBS) $(CGAL_LDLIBS)' > $(DESTDIR)$(PREFIX)/lib/pkgconfig/pantin.pc
	$(BUILD)/pantin manual -o $(share)/man/man1
	$(BUILD)/pantin completion bash > $(DESTDIR)$(PREFIX)/$(word 1,$(completions))
	$(BUILD)/pantin completion zsh > $(DESTDIR)$(PREFIX)/$(word 2,$(completions))
	$(BUILD)/pantin completion fish > $(DESTDIR)$(PREFIX)/$(word 3,$(completions))
uninstall:
	rm -f $(DESTDIR)$(PREFIX)/bin/pantin $(DESTDIR)$(PREFIX)/lib/libpantin.a $(DESTDIR)$(PREFIX)/lib/pkgconfig/pantin.pc
	rm -f $(share)/man/man1/pantin.1 $(share)/man/man1/pantin-*.1 $(addprefix $(DESTDIR)$(PREFIX)/,$(completions))
	rm -rf $(DESTDIR)$(PREFIX)/include/pantin
clean:
	rm -rf build out
