#!/bin/sh
# SPDX-License-Identifier: MIT
# Installs what is missing on Debian 12; quiet when nothing is. tools/install_deps.sh [build|format|tidy|bare-machine]; a library
# that the environment switches off (GLPK=0 ...) is left out.
set -eu
missing=""
need() { # need FILE PACKAGE
    for path in $1; do [ -e "$path" ] && return 0; done
    missing="$missing $2"
}
command -v "${CXX:-g++}" >/dev/null 2>&1 || missing="$missing g++"
need /usr/include/eigen3/Eigen/Core libeigen3-dev
need /usr/include/glpk.h libglpk-dev
need "/usr/include/stb/stb_image.h" libstb-dev
need /usr/include/nlohmann/json.hpp nlohmann-json3-dev
need /usr/include/CLI/CLI.hpp libcli11-dev
need /usr/include/catch2/catch.hpp catch2
need /usr/include/webp/mux.h libwebp-dev
need /usr/include/gif_lib.h libgif-dev
need /usr/include/yaml-cpp/yaml.h libyaml-cpp-dev
need /usr/include/pugixml.hpp libpugixml-dev
need /usr/include/valijson/validator.hpp libvalijson-dev
need /usr/bin/pkg-config pkg-config
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
