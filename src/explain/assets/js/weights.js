// SPDX-License-Identifier: MIT
// The weights of one bone as heat, or all bones mixed.
widgets.weights = (chapter, data) => {
    const select = show_controls(chapter).querySelector("select"), faces = [...chapter.querySelectorAll(".faces path")], mixed = faces.map(face => face.getAttribute("fill"));
    const weight_of = (vertex, bone) => {
        const w = data.weights[vertex];
        for (let k = 0; k < w.length; k += 2) if (w[k] === bone) return w[k + 1] / 1000;
        return 0;
    };
    select.addEventListener("change", () => {
        const bone = select.value === "" ? -1 : +select.value;
        faces.forEach((face, f) => {
            const corners = data.faces[f], mean = corners.reduce((sum, v) => sum + weight_of(v, bone), 0) / corners.length;
            face.setAttribute("fill", bone < 0 ? mixed[f] : css(heat(mean)));
        });
    });
};
