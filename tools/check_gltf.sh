#!/bin/sh
# SPDX-License-Identifier: MIT
# Validates every *.glb below a folder with the Khronos validator: no error and no warning is allowed.
# Usage: tools/check_gltf.sh FOLDER. Needs node and npm; the validator is installed once, into node_modules.
set -eu
folder=${1:?usage: tools/check_gltf.sh FOLDER}
root=$(cd "$(dirname "$0")/.." && pwd)
version=2.0.0-dev.3.10
command -v node >/dev/null 2>&1 || { echo "check_gltf: needs node (apt-get install nodejs npm)" >&2; exit 1; }
if [ ! -e "$root/node_modules/gltf-validator/package.json" ]; then
    npm install --prefix "$root" --ignore-scripts --no-save --no-package-lock --no-audit --no-fund --silent \
        "gltf-validator@$version" >&2
fi
NODE_PATH="$root/node_modules" node - "$folder" <<'SCRIPT'
const fs = require('fs'), path = require('path'), validator = require('gltf-validator');
const files = [];
(function collect(folder) {
    for (const entry of fs.readdirSync(folder, {withFileTypes: true}).sort((a, b) => (a.name < b.name ? -1 : 1))) {
        const name = path.join(folder, entry.name);
        if (entry.isDirectory()) collect(name);
        else if (name.endsWith('.glb')) files.push(name);
    }
})(process.argv[2]);
(async () => {
    let bad = files.length === 0 ? 1 : 0;
    if (bad) console.error('check_gltf: no *.glb below ' + process.argv[2]);
    for (const file of files) {
        const report = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), {maxIssues: 20});
        const {numErrors, numWarnings, numInfos, messages} = report.issues;
        console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos`);
        for (const m of messages) if (m.severity <= 2) console.log(`  ${m.code} ${m.pointer || ''}: ${m.message}`);
        if (numErrors + numWarnings > 0) bad = 1;
    }
    process.exit(bad);
})();
SCRIPT
