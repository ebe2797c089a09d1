// SPDX-License-Identifier: MIT
// The glTF file of the run, playing: from the front, or turning in space. It runs while it can be seen.
const play_glb = (chapter, data) => {
    if (!data) return;
    const place = chapter.querySelector(".viewer"), film = place.innerHTML, solid = place.dataset.kind === "solid";
    const controls = chapter.querySelector(".controls"), find = name => controls.querySelector("." + name);
    const clip = find("clip"), speed = find("speed"), output = controls.querySelector("output"), button = find("play");
    const say_speed = () => (output.textContent = `${(+speed.value).toFixed(2)} ×`);
    let view = null, playing = true;
    say_speed();

    const make_bones = root => {
        const joints = [];
        root.traverse(node => node.isBone && node.parent.isBone && joints.push(node));
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute("position", new THREE.Float32BufferAttribute(new Float32Array(6 * joints.length), 3));
        const lines = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: 0xd66000, depthTest: false}));
        lines.renderOrder = 9;
        lines.frustumCulled = false;
        const a = new THREE.Vector3(), update = () => {
            const position = geometry.attributes.position;
            joints.forEach((joint, k) => {
                a.setFromMatrixPosition(joint.parent.matrixWorld);
                position.setXYZ(2 * k, a.x, a.y, a.z);
                a.setFromMatrixPosition(joint.matrixWorld);
                position.setXYZ(2 * k + 1, a.x, a.y, a.z);
            });
            position.needsUpdate = true;
        };
        return {lines, update};
    };
    // The edges of the mesh, moved by the same skeleton.
    const make_mesh = mesh => {
        const wire = new THREE.SkinnedMesh(mesh.geometry, new THREE.MeshBasicMaterial({color: 0x2662d6, wireframe: true, transparent: true, opacity: 0.6}));
        wire.bind(mesh.skeleton, mesh.bindMatrix);
        wire.frustumCulled = false;
        wire.renderOrder = 5;
        return wire;
    };

    const start = async () => {
        if (view) return;
        view = {}; // no second start meanwhile
        const bytes = Uint8Array.from(atob(data.glb.slice(data.glb.indexOf(",") + 1)), c => c.charCodeAt(0));
        let renderer;
        try {
            renderer = new THREE.WebGLRenderer({antialias: true, alpha: true});
        } catch (error) {
            view = null; // the film stays
            return;
        }
        const gltf = await new THREE.GLTFLoader().parseAsync(bytes.buffer, "");
        const scene = new THREE.Scene();
        scene.add(gltf.scene, new THREE.HemisphereLight(0xffffff, 0x8a8f99, 2.2));
        const sun = new THREE.DirectionalLight(0xffffff, 1.6);
        sun.position.set(1, 2, 3);
        scene.add(sun);
        let mesh = null;
        gltf.scene.traverse(node => node.isSkinnedMesh && (mesh = node));
        mesh.frustumCulled = false;
        const bones = make_bones(gltf.scene), wire = make_mesh(mesh);
        scene.add(bones.lines, wire);
        const mixer = new THREE.AnimationMixer(gltf.scene);

        const width = data.width / data.height, reach = 0.62 * Math.max(1, width); // world: the drawing is one unit high
        const camera = new THREE.OrthographicCamera(-reach, reach, reach, -reach, -10, 20);
        camera.position.set(0, 0.5, 5);
        const orbit = new THREE.OrbitControls(camera, renderer.domElement);
        orbit.target.set(0, 0.5, 0);
        orbit.enablePan = false;
        orbit.enableZoom = false;
        orbit.autoRotateSpeed = 3;
        const canvas = renderer.domElement;
        canvas.tabIndex = 0;
        canvas.setAttribute("role", "img");
        canvas.setAttribute("aria-label", (solid ? "The solid" : "The drawing") + ", moving; arrow keys turn it, Home shows the front");
        const turn = (around, over) => {
            const s = new THREE.Vector3().subVectors(camera.position, orbit.target), r = s.length();
            const angle = Math.atan2(s.x, s.z) + around, height = Math.min(1.4, Math.max(-1.4, Math.asin(s.y / r) + over));
            camera.position.set(orbit.target.x + r * Math.cos(height) * Math.sin(angle), orbit.target.y + r * Math.sin(height), orbit.target.z + r * Math.cos(height) * Math.cos(angle));
        };
        canvas.addEventListener("keydown", event => {
            const move = {ArrowLeft: [-0.15, 0], ArrowRight: [0.15, 0], ArrowUp: [0, 0.15], ArrowDown: [0, -0.15]}[event.key];
            if (event.key === "Home") camera.position.set(0, 0.5, 5);
            if (!move) return;
            event.preventDefault();
            turn(...move);
        });
        place.replaceChildren(canvas);

        const choose = () => {
            mixer.stopAllAction();
            const animation = gltf.animations.find(a => a.name === clip.value) || gltf.animations[0];
            if (animation) mixer.clipAction(animation).play();
        };
        choose();
        let before = performance.now(), frame = 0;
        const draw = now => {
            frame = requestAnimationFrame(draw);
            const seconds = Math.min(0.1, (now - before) / 1000);
            before = now;
            if (playing) mixer.update(seconds * speed.value);
            const side = place.clientWidth;
            if (canvas.width !== Math.round(side * devicePixelRatio)) {
                renderer.setPixelRatio(devicePixelRatio);
                renderer.setSize(side, side);
            }
            orbit.autoRotate = find("turn").checked;
            orbit.update(seconds);
            wire.visible = find("mesh").checked;
            bones.lines.visible = find("bones").checked;
            scene.updateMatrixWorld();
            if (bones.lines.visible) bones.update();
            renderer.render(scene, camera);
        };
        draw(before);
        clip.addEventListener("change", choose);
        view = {stop: () => {
            cancelAnimationFrame(frame);
            clip.removeEventListener("change", choose);
            orbit.dispose();
            renderer.dispose();
            renderer.forceContextLoss();
            place.innerHTML = film;
        }};
        place.dataset.running = "yes";
    };

    show_controls(chapter);
    speed.addEventListener("input", say_speed);
    button.addEventListener("click", () => {
        playing = !playing;
        button.textContent = playing ? "Pause" : "Play";
        button.setAttribute("aria-pressed", playing);
    });
    if (matchMedia("(prefers-reduced-motion: reduce)").matches) button.click();
    new IntersectionObserver(entries => {
        if (entries[entries.length - 1].isIntersecting) start();
        else if (view && view.stop) {
            view.stop();
            view = null;
            delete place.dataset.running;
        }
    }, {rootMargin: "100px"}).observe(place);
};
widgets.motion = play_glb;
widgets.solid = play_glb;
