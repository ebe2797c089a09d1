#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes src/explain/assets/three.min.js: what the walkthrough's viewer needs of three.js (MIT), as one script that defines THREE.
# Needs node and npm; run it to take another version of three.js.
set -eu
version=${1:-0.187.0}
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
npm init -y >/dev/null
npm install --no-audit --no-fund --silent "three@$version" esbuild@0.28.2 >/dev/null
cat > names.js <<'NAMES'
export {AnimationMixer, BufferGeometry, DirectionalLight, Float32BufferAttribute, HemisphereLight, LineBasicMaterial, LineSegments,
    MeshBasicMaterial, OrthographicCamera, Scene, SkinnedMesh, Vector3, WebGLRenderer} from 'three';
export {GLTFLoader} from 'three/addons/loaders/GLTFLoader.js';
export {OrbitControls} from 'three/addons/controls/OrbitControls.js';
NAMES
npx esbuild names.js --bundle --minify --format=iife --global-name=THREE --legal-comments=inline --outfile=three.js
{
    printf '/* three.js %s, https://threejs.org, MIT licence:\n' "$version"
    cat node_modules/three/LICENSE
    printf '*/\n'
    cat three.js
} > "$root/src/explain/assets/three.min.js"
