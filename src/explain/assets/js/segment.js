// SPDX-License-Identifier: MIT
// Probabilities of the pixel that is pointed at: each map keeps them in its opacity.
widgets.segment = async chapter => {
    const figures = [...chapter.querySelectorAll(".maps figure")];
    const maps = await Promise.all(figures.map(figure => load_pixels(figure.querySelector("image").getAttribute("href"))));
    const show = (x, y) => figures.forEach((figure, k) => {
        const {width, height, data} = maps[k];
        const u = Math.min(width - 1, Math.floor(x * width)), v = Math.min(height - 1, Math.floor(y * height));
        figure.querySelector("output").textContent = (data[4 * (v * width + u) + 3] / 255).toFixed(2);
    });
    for (const figure of figures)
        figure.querySelector("svg").addEventListener("pointermove", event => {
            const box = event.currentTarget.getBoundingClientRect();
            show((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
        });
};
