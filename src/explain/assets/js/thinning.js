// SPDX-License-Identifier: MIT
// Thinning, one frame a sub-iteration, and the judgement of one pixel.
widgets.thinning = async (chapter, data) => {
    const controls = show_controls(chapter), choice = controls.querySelector("select"), slider = controls.querySelector("input");
    const output = controls.querySelector("output"), play = controls.querySelector("button"), judgement = chapter.querySelector(".judgement");
    const stage = chapter.querySelector(".stage"), still = stage.querySelector("svg");
    const canvas = document.createElement("canvas"), context = canvas.getContext("2d");
    const zoom = Math.max(1, Math.round(720 / Math.max(data.width, data.height)));
    canvas.width = data.width * zoom;
    canvas.height = data.height * zoom;
    canvas.dataset.zoom = zoom;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "img");
    canvas.setAttribute("aria-label", "Pixels that are left; arrow keys choose a pixel, plus and minus go through the sub-iterations");
    canvas.style.setProperty("--ratio", data.width / data.height);
    still.replaceWith(canvas);

    const loaded = {};
    let began, removed, last, chosen = null, timer = 0;
    const load = async name => {
        if (!loaded[name]) {
            const {data: rgba} = await load_pixels(data[name].picture);
            const n = data.width * data.height, set = new Uint8Array(n), when = new Uint16Array(n);
            for (let i = 0; i < n; ++i) {
                set[i] = rgba[4 * i];
                when[i] = rgba[4 * i + 1] * 256 + rgba[4 * i + 2];
            }
            loaded[name] = {set, when, last: data[name].last};
        }
        ({set: began, when: removed, last} = loaded[name]);
        slider.max = last;
    };

    const step = () => +slider.value; // sub-iterations that are done
    const black = (x, y, done = step()) => {
        if (x < 0 || y < 0 || x >= data.width || y >= data.height) return 0;
        const i = y * data.width + x;
        return began[i] && (removed[i] === 0 || removed[i] > done) ? 1 : 0;
    };
    const draw = () => {
        context.fillStyle = "#fff";
        context.fillRect(0, 0, canvas.width, canvas.height);
        for (let y = 0; y < data.height; ++y)
            for (let x = 0; x < data.width; ++x) {
                const i = y * data.width + x;
                if (!began[i]) continue;
                const left = black(x, y), next = left && removed[i] === step() + 1;
                context.fillStyle = next ? "#d66000" : left ? "#111" : "#dcdfe5";
                context.fillRect(x * zoom, y * zoom, zoom, zoom);
            }
        if (chosen) {
            context.strokeStyle = "#2662d6";
            context.lineWidth = Math.max(2, zoom / 2);
            context.strokeRect((chosen.x - 1) * zoom, (chosen.y - 1) * zoom, 3 * zoom, 3 * zoom);
        }
        output.textContent = `${step()} of ${last} done` + (step() < last ? "; orange goes next" : "");
        judge();
    };

    // The neighbours of Algorithm 4.1: P2 above, then clockwise.
    const around = [[0, -1], [1, -1], [1, 0], [1, 1], [0, 1], [-1, 1], [-1, 0], [-1, -1]];
    const judge = () => {
        if (!chosen) {
            judgement.textContent = "No pixel is chosen yet.";
            return;
        }
        const {x, y} = chosen, p = [0, black(x, y), ...around.map(([dx, dy]) => black(x + dx, y + dy))]; // p[1] … p[9]
        const b = p.slice(2).reduce((sum, v) => sum + v, 0);
        let a = 0;
        for (let i = 2; i <= 9; ++i) a += p[i] === 0 && p[i === 9 ? 2 : i + 1] === 1 ? 1 : 0;
        const second = (step() + 1) % 2 === 0;
        const products = second ? [["P₂P₄P₈", p[2] * p[4] * p[8]], ["P₂P₆P₈", p[2] * p[6] * p[8]]] : [["P₂P₄P₆", p[2] * p[4] * p[6]], ["P₄P₆P₈", p[4] * p[6] * p[8]]];
        const tests = [[`2 ≤ B ≤ 6: B = ${b}`, b >= 2 && b <= 6], [`A = 1: A = ${a}`, a === 1], ...products.map(([name, v]) => [`${name} = 0: it is ${v}`, v === 0])];
        const cell = (k, self) => `<td class="${p[k] ? "on" : "off"}${self ? " self" : ""}">P<sub>${k}</sub></td>`;
        const goes = p[1] && tests.every(([, ok]) => ok);
        const verdict = !p[1] ? "This pixel is white; only black ones are judged." : goes ? `It goes in sub-iteration ${step() + 1}.` : `It stays in sub-iteration ${step() + 1}.`;
        judgement.innerHTML = `<table aria-label="The pixel and its neighbours"><tr>${cell(9)}${cell(2)}${cell(3)}</tr><tr>${cell(8)}${cell(1, true)}${cell(4)}</tr><tr>${cell(7)}${cell(6)}${cell(5)}</tr></table>` +
            `<div><p>Pixel (${x}, ${y}), ${second ? "second" : "first"} kind of sub-iteration.</p><ul>${tests.map(([text, ok]) => `<li class="${ok ? "yes" : "no"}">${text}</li>`).join("")}</ul><p class="verdict">${verdict}</p></div>`;
    };

    const go_to = value => {
        slider.value = value;
        draw();
    };
    const stop = () => {
        clearInterval(timer);
        timer = 0;
        play.textContent = "Play";
    };
    play.addEventListener("click", () => {
        if (timer) return stop();
        if (step() >= last) go_to(0);
        play.textContent = "Stop";
        timer = setInterval(() => (step() < last ? go_to(step() + 1) : stop()), Math.max(60, Math.min(500, 6000 / last)));
    });
    slider.addEventListener("input", draw);
    choice.addEventListener("change", async () => {
        stop();
        await load(choice.value);
        go_to(0);
    });
    canvas.addEventListener("click", event => {
        const at = (place, side, count) => Math.min(count - 1, Math.max(0, Math.floor(place / side * count)));
        chosen = {x: at(event.offsetX, canvas.clientWidth, data.width), y: at(event.offsetY, canvas.clientHeight, data.height)};
        draw();
    });
    canvas.addEventListener("keydown", event => {
        const move = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]}[event.key];
        if (event.key === "+" || event.key === "-") return go_to(step() + (event.key === "+" ? 1 : -1));
        if (!move) return;
        event.preventDefault();
        const from = chosen || first_black();
        chosen = chosen ? {x: Math.min(data.width - 1, Math.max(0, from.x + move[0])), y: Math.min(data.height - 1, Math.max(0, from.y + move[1]))} : from;
        draw();
    });
    const first_black = () => {
        const i = began.findIndex((v, k) => v && removed[k] > 0);
        return {x: i % data.width, y: Math.floor(i / data.width)};
    };
    stage.querySelector("figcaption").textContent = "Black: still there. Orange: goes next. Grey: gone. The blue frame is the pixel that is judged, with its neighbours.";
    choice.value = data.ridges.last > 0 ? "ridges" : "silhouette"; // edges that are thin already lose nothing
    await load(choice.value);
    chosen = first_black();
    if (chosen.x < 0) chosen = null;
    draw();
};
