// SPDX-License-Identifier: MIT
// A chapter begins to answer when it comes near the window.
const near = new IntersectionObserver(entries => {
    for (const entry of entries) {
        if (!entry.isIntersecting) continue;
        near.unobserve(entry.target);
        const widget = widgets[entry.target.dataset.widget];
        if (widget) Promise.resolve(widget(entry.target, read_data(entry.target))).then(() => (entry.target.dataset.ready = "yes"));
    }
}, {rootMargin: "800px"});
for (const chapter of document.querySelectorAll("[data-widget]")) near.observe(chapter);
if (matchMedia("(max-width: 40rem)").matches) document.querySelector("nav details").open = false;
document.documentElement.dataset.ready = "yes";
