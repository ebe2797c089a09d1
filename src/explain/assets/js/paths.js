// SPDX-License-Identifier: MIT
// Look into a cell of the similarity table, and from there at two paths.
widgets.paths = (chapter, data) => {
    if (!data) return;
    const similarity = chapter.querySelector(".similarity table"), holder = chapter.querySelector(".bijection"), pair = holder.querySelector(".pair");
    const [mine, theirs] = chapter.querySelectorAll(".row .track"), curves = chapter.querySelectorAll(".curves path"), output = chapter.querySelector("figure:last-of-type output");
    const n = data.paths.length, m = data.reference_paths.length;
    const letter = k => String.fromCharCode(65 + k);
    let [i, j] = data.start;
    const curve = radii => radii.map((r, k) => `${k ? "L" : "M"}${(data.chart[0] * k / (radii.length - 1)).toFixed(1)} ${(data.chart[1] * (1 - r / data.most)).toFixed(1)}`).join("");
    const look_at = (k, l) => {
        holder.querySelectorAll("td").forEach(td => td.classList.toggle("looked", +td.dataset.i === k && +td.dataset.j === l));
        const p = data.paths[i][k], q = data.reference_paths[j][l];
        curves[0].setAttribute("d", curve(p.radii));
        curves[1].setAttribute("d", curve(q.radii));
        mine.setAttribute("d", data.ways[i][k]);
        theirs.setAttribute("d", data.reference_ways[j][l]);
        output.textContent = `Lengths ${p.length.toFixed(1)} and ${q.length.toFixed(1)} mean thicknesses; difference ${data.comparisons[i][j].distances[k][l].toFixed(2)}.`;
    };
    const open = (row, column) => {
        [i, j] = [row, column];
        const {distances, path, cost} = data.comparisons[i][j];
        similarity.querySelectorAll("td").forEach(td => td.classList.toggle("chosen", +td.dataset.i === i && +td.dataset.j === j));
        pair.textContent = `${i + 1} and ${letter(j)} (cost ${cost.toFixed(2)})`;
        const head = distances[0].map((_, l) => `<th scope="col">${letter(j)} → ${letter((j + 1 + l) % m)}</th>`).join("");
        const chosen = (k, l) => path.some(([a, b]) => a === k && b === l);
        const rows = distances.map((line, k) => `<tr><th scope="row">${i + 1} → ${(i + 1 + k) % n + 1}</th>` +
            line.map((d, l) => `<td class="${chosen(k, l) ? "chosen" : ""}" data-i="${k}" data-j="${l}">${d.toFixed(2)}</td>`).join("") + "</tr>");
        holder.querySelector("table").innerHTML = `<thead><tr><th>paths</th>${head}</tr></thead><tbody>${rows.join("")}</tbody>`;
        holder.querySelectorAll("td").forEach(td => on_choice(td, () => look_at(+td.dataset.i, +td.dataset.j)));
        look_at(...(path.length ? path[0] : [0, 0]));
    };
    similarity.querySelectorAll("td").forEach(td => on_choice(td, () => open(+td.dataset.i, +td.dataset.j)));
    open(i, j);
};
