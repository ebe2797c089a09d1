// SPDX-License-Identifier: MIT
// The threshold prunes the edges while it is moved.
widgets.voronoi = (chapter, data) => {
    const controls = show_controls(chapter), slider = controls.querySelector("input"), output = controls.querySelector("output");
    const group = chapter.querySelector("svg .edges"), paths = [...group.children];
    const shades = paths.length, edges = data.edges, count = edges.length / 5;
    const shade_of = residual => Math.min(shades - 1, Math.floor(Math.sqrt(Math.min(residual, data.most) / data.most) * shades));
    const pruned = paths[0].cloneNode();
    pruned.setAttribute("stroke", "#b9bcc4");
    group.prepend(pruned);
    const draw = () => {
        const threshold = 10 * slider.value, texts = paths.map(() => []), dropped = [];
        let kept = 0;
        for (let i = 0; i < edges.length; i += 5) {
            const residual = edges[i + 4], stays = residual >= threshold;
            kept += stays;
            (stays ? texts[shade_of(residual / 10)] : dropped).push(`M${edges[i] / 10} ${edges[i + 1] / 10}L${edges[i + 2] / 10} ${edges[i + 3] / 10}`);
        }
        pruned.setAttribute("d", dropped.join(""));
        paths.forEach((path, k) => path.setAttribute("d", texts[k].join("")));
        const used = Math.abs(slider.value - data.threshold) < 0.06 ? " (used in this run)" : "";
        output.textContent = `${(+slider.value).toFixed(1)} pixels: ${kept} of ${count} edges stay${used}`;
    };
    slider.addEventListener("input", draw);
    draw();
};
