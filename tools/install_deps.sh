#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what is missing on Debian 12; quiet when nothing is. tools/install_deps.sh [WHAT], WHAT one of
#   build          what `make` and the tests need (default); a library that the environment switches off (GLPK=0 ...) is left out
#   format         the formatter of `make format`
#   tidy           clang-tidy
#   bare-machine   what tools/bare_machine.sh needs
set -eu
missing=""
need() { # need FILE PACKAGE
    [ -e "$1" ] || missing="$missing $2"
}
optional() { # optional SWITCH FILE PACKAGE
    [ "$1" = 0 ] || need "$2" "$3"
}
case ${1:-build} in
build)
    compiler=${CXX:-g++}
    compiler=${compiler##* } # "ccache g++"
    if ! command -v "$compiler" >/dev/null 2>&1; then
        case $compiler in
        g++) missing="$missing g++" ;;
        clang++) missing="$missing clang" ;;
        *) echo "pantin: this machine has no compiler '$compiler'" >&2 && exit 1 ;;
        esac
    fi
    need /usr/include/eigen3/Eigen/Core libeigen3-dev
    need /usr/include/stb/stb_image.h libstb-dev
    need /usr/include/nlohmann/json.hpp nlohmann-json3-dev
    need /usr/include/CLI/CLI.hpp libcli11-dev
    need /usr/include/catch2/catch.hpp catch2
    need /usr/include/valijson/validator.hpp libvalijson-dev
    need /usr/bin/pkg-config pkg-config
    optional "${GLPK:-1}" /usr/include/glpk.h libglpk-dev
    optional "${WEBP:-1}" /usr/include/webp/mux.h libwebp-dev
    optional "${GIF:-1}" /usr/include/gif_lib.h libgif-dev
    optional "${YAML:-1}" /usr/include/yaml-cpp/yaml.h libyaml-cpp-dev
    optional "${PUGIXML:-1}" /usr/include/pugixml.hpp libpugixml-dev
    [ "${CGAL:-0}" = 0 ] || { need /usr/include/CGAL/version.h libcgal-dev && need /usr/include/mpfr.h libmpfr-dev; }
    ;;
format) need /usr/bin/clang-format-14 clang-format-14 ;;
tidy) need /usr/bin/clang-tidy-14 clang-tidy-14 ;;
bare-machine) need /usr/bin/mmdebstrap mmdebstrap ;;
*) echo "usage: tools/install_deps.sh [build|format|tidy|bare-machine]" >&2 && exit 2 ;;
esac
[ -z "$missing" ] && exit 0
if ! command -v apt-get >/dev/null 2>&1; then
    echo "pantin: this machine has no apt-get; please install by hand the counterparts of:$missing" >&2
    exit 1
fi
sudo=""
if [ "$(id -u)" != 0 ]; then
    if ! command -v sudo >/dev/null 2>&1; then
        echo "pantin: please run as root: apt-get install$missing" >&2
        exit 1
    fi
    sudo=sudo
fi
echo "pantin: installing$missing"
$sudo apt-get update -qq
# shellcheck disable=SC2086
$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $missing >/dev/null
