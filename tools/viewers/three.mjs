// SPDX-License-Identifier: MIT
// One frame of a clip as three.js shows it, in headless Chromium with software GL.
// usage: node three.mjs GLB CLIP SECONDS X0 Y0 X1 Y1 WIDTH HEIGHT OUT.png
// The rectangle of the plane z = 0 from (X0, Y0) to (X1, Y1), world units, fills the picture; the background is
// transparent. Needs three and playwright-core beside it (compare.py installs them) and Debian's chromium.
import {readFileSync, existsSync} from 'node:fs';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {chromium} from 'playwright-core';

const [glb, clip, seconds, x0, y0, x1, y1, width, height, out] = process.argv.slice(2);
if (!out) {
    console.error('usage: three.mjs GLB CLIP SECONDS X0 Y0 X1 Y1 WIDTH HEIGHT OUT.png');
    process.exit(2);
}
const modules = join(dirname(fileURLToPath(import.meta.url)), 'node_modules');
const site = 'http://viewer.test'; // never asked for: every request is answered from the disk
const page_text = `<!doctype html><style>body { margin: 0; background: transparent } canvas { display: block }</style>
<script type="importmap">
{"imports": {"three": "/three/build/three.module.js", "three/addons/": "/three/examples/jsm/"}}
</script>`;

function answer(route) {
    const path = decodeURIComponent(new URL(route.request().url()).pathname);
    if (path === '/') return route.fulfill({contentType: 'text/html', body: page_text});
    if (path === '/character.glb') return route.fulfill({contentType: 'model/gltf-binary', body: readFileSync(glb)});
    const file = join(modules, path);
    if (!existsSync(file)) return route.fulfill({status: 404, body: ''});
    return route.fulfill({contentType: 'text/javascript', body: readFileSync(file)});
}

// Runs in the page.
async function show({clip, seconds, x0, y0, x1, y1, width, height}) {
    const THREE = await import('three');
    const {GLTFLoader} = await import('three/addons/loaders/GLTFLoader.js');
    const gltf = await new GLTFLoader().loadAsync('/character.glb');
    const scene = new THREE.Scene();
    scene.add(gltf.scene);

    const animation = THREE.AnimationClip.findByName(gltf.animations, clip);
    if (!animation) throw new Error('no clip ' + clip);
    const mixer = new THREE.AnimationMixer(gltf.scene);
    mixer.clipAction(animation).play();
    mixer.setTime(seconds);

    const camera = new THREE.OrthographicCamera(x0, x1, y1, y0, 0, 20);
    camera.position.z = 10;
    const renderer = new THREE.WebGLRenderer({antialias: true, alpha: true, preserveDrawingBuffer: true});
    renderer.setSize(width, height);
    document.body.append(renderer.domElement);
    renderer.render(scene, camera);
}

const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM || '/usr/bin/chromium',
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
    const page = await browser.newPage({viewport: {width: +width, height: +height}});
    page.on('console', message => message.type() === 'error' && console.error(message.text()));
    await page.route(site + '/**', answer);
    await page.goto(site + '/');
    await page.evaluate(
        show, {clip, seconds: +seconds, x0: +x0, y0: +y0, x1: +x1, y1: +y1, width: +width, height: +height});
    await page.screenshot({path: out, omitBackground: true});
} finally {
    await browser.close();
}
