#!/bin/sh
# SPDX-License-Identifier: MIT
# Explains three pages and checks the results in headless Chromium (check_page.mjs). Usage: tools/web/check_page.sh PANTIN FOLDER
# Needs node, npm and chromium; playwright-core is installed once, into node_modules.
set -eu
pantin=${1:?usage: check_page.sh PANTIN FOLDER} folder=${2:?usage: check_page.sh PANTIN FOLDER}
root=$(cd "$(dirname "$0")/../.." && pwd)
for program in node npm "${CHROMIUM:-chromium}"; do
    command -v "$program" >/dev/null 2>&1 || { echo "check_page: needs $program (apt-get install nodejs npm chromium)" >&2; exit 1; }
done
[ -e "$root/node_modules/playwright-core/package.json" ] ||
    npm install --prefix "$root" --ignore-scripts --no-save --no-package-lock --no-audit --no-fund --silent playwright-core@1.64.1 >&2
for page in humanoid quadruped flying; do
    "$pantin" explain "$root/testdata/$page.png" -o "$folder/$page" --quiet
    node "$root/tools/web/check_page.mjs" "$folder/$page/index.html" "$folder/$page/screenshots"
done
