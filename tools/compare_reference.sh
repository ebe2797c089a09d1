#!/bin/sh
# SPDX-License-Identifier: MIT
# compare_reference.sh REFERENCE_DIR DATA_DIR: builds the comparison program and compares every stage with the
# stored reference results. Run by hand; the results it reads are not part of the project.
set -eu
[ $# -eq 2 ] || { echo "usage: tools/compare_reference.sh REFERENCE_DIR DATA_DIR" >&2; exit 2; }
reference=$(realpath "$1")
data=$(realpath "$2")
cd "$(dirname "$0")/.."
make --no-print-directory build/release/compare_reference
exec build/release/compare_reference "$reference" "$data"
