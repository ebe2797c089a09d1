// SPDX-License-Identifier: MIT
// What the widgets share. A widget makes one chapter answer; without it the chapter stays as it is.
const widgets = {};

const read_data = chapter => {
    const script = chapter.querySelector("script.data");
    return script ? JSON.parse(script.textContent) : null;
};

const show_controls = chapter => {
    const controls = chapter.querySelector(".controls");
    if (controls) controls.hidden = false;
    return controls;
};

// From violet (0) over green to yellow (1), as the still pictures have it.
const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
const heat = share => {
    const at = 4 * Math.min(1, Math.max(0, share)), i = Math.min(3, Math.floor(at));
    return stops[i].map((v, k) => Math.round(v + (at - i) * (stops[i + 1][k] - v)));
};
const css = ([r, g, b]) => `rgb(${r},${g},${b})`;

// Pixels of a picture inside the page, as it was encoded.
const load_pixels = async uri => {
    const image = new Image();
    image.src = uri;
    await image.decode();
    const canvas = document.createElement("canvas");
    canvas.width = image.naturalWidth;
    canvas.height = image.naturalHeight;
    const context = canvas.getContext("2d", {willReadFrequently: true});
    context.drawImage(image, 0, 0);
    return context.getImageData(0, 0, canvas.width, canvas.height);
};

// Calls `act` when the element is clicked, or chosen with Enter or the space bar.
const on_choice = (element, act) => {
    element.tabIndex = 0;
    element.setAttribute("role", "button");
    element.addEventListener("click", act);
    element.addEventListener("keydown", event => {
        if (event.key !== "Enter" && event.key !== " ") return;
        event.preventDefault();
        act(event);
    });
};
