#!/bin/sh
# SPDX-License-Identifier: MIT
# Same input, same bytes: builds the program with other compilers and options, animates the test pages with each
# build and with other numbers of threads, and compares every file with those of the first run. WebP, GIF and PNG are
# compared as files, too: one machine has one encoder. Usage: tools/check_determinism.sh [PAGE…]
set -eu
cd "$(dirname "$0")/.."
[ $# -gt 0 ] || set -- testdata/humanoid.png testdata/quadruped.png testdata/flying.png
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0

animate() { # animate NAME BINARY THREADS PAGE…
    name=$1 binary=$2 threads=$3
    shift 3
    for page in "$@"; do
        "$binary" animate "$page" -o "$work/$name/$(basename "$page")" --threads "$threads" --size 128 --fps 5 --quiet
    done
}
compare() { # compare NAME: against the first run
    if diff -r "$work/first" "$work/$1" >"$work/$1.diff" 2>&1; then
        echo "same bytes: $1"
    else
        echo "DIFFERENT: $1"
        head -n 5 "$work/$1.diff"
        status=1
    fi
}

make -s -j2 build/release/pantin
make -s -j2 config=debug build/debug/pantin
animate first build/release/pantin 1 "$@"
animate threads-2 build/release/pantin 2 "$@" && compare threads-2
animate threads-7 build/release/pantin 7 "$@" && compare threads-7
animate debug build/debug/pantin 2 "$@" && compare debug
for variant in avx2 baseline; do
    PANTIN_SIMD=$variant animate "$variant" build/release/pantin 2 "$@" && compare "$variant"
done
if command -v clang++ >/dev/null 2>&1; then
    make -s -j2 CXX=clang++ BUILD=build/clang build/clang/pantin
    animate clang build/clang/pantin 2 "$@" && compare clang
fi
exit $status
