#!/bin/sh
# SPDX-License-Identifier: MIT
# compare_reference.sh REFERENCE_DIR DATA_DIR [CONFIG]: builds the comparison program (CONFIG: release, as make's config) and
# compares every stage with the stored reference results. They are not part of the project; CI runs this where they are there.
set -eu
[ $# -eq 2 ] || [ $# -eq 3 ] || { echo "usage: tools/compare_reference.sh REFERENCE_DIR DATA_DIR [CONFIG]" >&2; exit 2; }
reference=$(realpath "$1")
data=$(realpath "$2")
config=${3:-release}
cd "$(dirname "$0")/.."
make --no-print-directory config="$config" "build/$config/compare_reference"
exec "build/$config/compare_reference" "$reference" "$data"
