// fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Curves as SVG, with the values under the pointer and files to save.

const COLOURS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"];
const SVG = "http://www.w3.org/2000/svg";
const BOX = { width: 384, height: 220, left: 62, right: 24, top: 10, bottom: 34 };
const charts = [];

function make(tag, attributes, parent, text) {
    const space = parent instanceof SVGElement || tag === "svg";
    const made = space ? document.createElementNS(SVG, tag) : document.createElement(tag);
    for (const [k, v] of Object.entries(attributes)) made.setAttribute(k, v);
    if (text !== undefined) made.textContent = text;
    if (parent) parent.appendChild(made);
    return made;
}

function short(x) {
    if (x === null || x === undefined) return "-";
    const size = Math.abs(x);
    if (size !== 0 && (size < 1e-3 || size >= 1e5)) return x.toExponential(3).replace("e+", "e");
    return String(Number(x.toPrecision(5)));
}

// The same without the zeros behind
function tick(x) {
    const size = Math.abs(x), value = Number(x.toPrecision(4));
    if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential().replace("e+", "e");
    return String(value);
}

function save(name, type, text) {
    const link = make("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
    link.click();
    URL.revokeObjectURL(link.href);
}

// Round values between two ends
function ticks(low, high, most) {
    const rough = (high - low) / most;
    const unit = Math.pow(10, Math.floor(Math.log10(rough)));
    const step = [1, 2, 5, 10].map(f => f * unit).find(s => s >= rough * 0.999);
    const found = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) found.push(i * step);
    return found;
}

// Ends of an axis; what does not vary gets some room
function ends(values, log) {
    const known = values.filter(v => v !== null && (!log || v > 0)).map(v => log ? Math.log10(v) : v);
    let low = known.reduce((a, b) => Math.min(a, b), Infinity);
    let high = known.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!known.length) [low, high] = [0, 1];
    if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high))) {
        const room = log ? 0.5 : Math.max(Math.abs(high), 1e-30) * 0.1;
        [low, high] = [low - room, high + room];
    }
    return [low, high];
}

// One chart, or the numbers if there is but one time. spec: title, unit, x, xUnit, series [{name, y, dots}], log, table (for the csv file)
function chart(parent, spec) {
    const box = make("div", { class: "chart" }, parent);
    const head = make("h4", {}, box, spec.title + " ");
    make("small", {}, head, spec.unit && spec.unit !== "-" ? `(${spec.unit})` : "");
    const svgButton = make("button", { class: "save" }, head, "svg");
    const csvButton = make("button", { class: "save" }, head, "csv");
    const svg = make("svg", { viewBox: `0 0 ${BOX.width} ${BOX.height}` }, box);
    const legend = make("div", { class: "legend" }, box);
    const tell = row => {
        legend.textContent = "";
        if (row !== null) make("span", {}, legend, `${short(spec.x[row])} ${spec.xUnit}`);
        spec.series.forEach((s, i) => {
            const text = row === null ? s.name : `${s.name} ${short(s.y[row])}`;
            make("span", { style: `color:${s.colour || COLOURS[i % 6]}` }, legend, text);
        });
    };
    csvButton.onclick = () => save(`${spec.title}.csv`, "text/csv", comma(spec));
    if (spec.x.length < 2) {
        svg.remove();
        svgButton.remove();
        tell(0);
        return;
    }
    const [x0, x1] = ends(spec.x, false);
    const [y0, y1] = ends(spec.series.flatMap(s => s.y), spec.log);
    const px = x => BOX.left + (x - x0) / (x1 - x0) * (BOX.width - BOX.left - BOX.right);
    const py = y => BOX.top + (y1 - (spec.log ? Math.log10(y) : y)) / (y1 - y0)
        * (BOX.height - BOX.top - BOX.bottom);
    axes(svg, spec, [x0, x1], [y0, y1], px, py);
    spec.series.forEach((s, i) => draw(svg, spec, s, s.colour || COLOURS[i % 6], px, py));
    const cursor = make("line", { class: "cursor", y1: BOX.top, y2: BOX.height - BOX.bottom,
        visibility: "hidden" }, svg);

    const show = time => {
        const at = nearest(spec.x, time);
        cursor.setAttribute("visibility", "visible");
        for (const end of ["x1", "x2"]) cursor.setAttribute(end, px(spec.x[at]));
        tell(at);
    };
    svg.addEventListener("pointermove", event => {
        const at = (event.clientX - svg.getBoundingClientRect().left) * BOX.width / svg.clientWidth;
        show(x0 + (at - BOX.left) / (BOX.width - BOX.left - BOX.right) * (x1 - x0));
    });
    svg.addEventListener("pointerleave", () => {
        cursor.setAttribute("visibility", "hidden");
        tell(null);
    });
    svgButton.onclick = () => save(`${spec.title}.svg`, "image/svg+xml", standalone(svg));
    tell(null);
    charts.push({ spec, show });
}

// Values on a logarithmic axis between two exponents
function powers(low, high) {
    const every = Math.ceil((high - low) / 7);
    const found = [];
    for (let e = Math.floor(low); e <= high; ++e) {
        const within = f => e + Math.log10(f) >= low && e + Math.log10(f) <= high;
        if (e % every === 0 && within(1)) found.push(Math.pow(10, e));
        if (high - low < 1.5) found.push(...[2, 3, 5].filter(within).map(f => f * Math.pow(10, e)));
    }
    return found;
}

function axes(svg, spec, [x0, x1], [y0, y1], px, py) {
    for (const x of ticks(x0, x1, 5)) {
        make("line", { class: "grid", x1: px(x), x2: px(x), y1: BOX.top, y2: BOX.height - BOX.bottom }, svg);
        make("text", { class: "tick", x: px(x), y: BOX.height - 18, "text-anchor": "middle" }, svg, tick(x));
    }
    for (const y of spec.log ? powers(y0, y1) : ticks(y0, y1, 5)) {
        make("line", { class: "grid", x1: BOX.left, x2: BOX.width - BOX.right, y1: py(y), y2: py(y) }, svg);
        make("text", { class: "tick", x: BOX.left - 6, y: py(y) + 4, "text-anchor": "end" }, svg, tick(y));
    }
    make("text", { class: "tick", x: BOX.width - BOX.right, y: BOX.height - 3, "text-anchor": "end" },
        svg, `time (${spec.xUnit})`);
    make("path", { class: "axis", fill: "none",
        d: `M${BOX.left} ${BOX.top}V${BOX.height - BOX.bottom}H${BOX.width - BOX.right}` }, svg);
}

function draw(svg, spec, series, colour, px, py) {
    let path = "", pen = "M";
    const few = series.dots || spec.x.length < 12;
    spec.x.forEach((x, i) => {
        const y = series.y[i];
        if (y === null || y === undefined || (spec.log && y <= 0)) {
            pen = "M";
            return;
        }
        path += `${pen}${px(x).toFixed(1)} ${py(y).toFixed(1)}`;
        pen = "L";
        if (few) make("circle", { cx: px(x), cy: py(y), r: 2.4, fill: colour }, svg);
    });
    if (!series.dots) make("path", { d: path, fill: "none", stroke: colour, "stroke-width": 1.6 }, svg);
}

function nearest(values, wanted) {
    let best = 0;
    values.forEach((v, i) => { if (Math.abs(v - wanted) < Math.abs(values[best] - wanted)) best = i; });
    return best;
}

function comma(spec) {
    const names = [`time (${spec.xUnit})`, ...spec.series.map(s => s.name)];
    const rows = spec.x.map((x, i) => [x, ...spec.series.map(s => s.y[i])]);
    return [names, ...rows].map(r => r.join(",")).join("\n") + "\n";
}

// With its colours, for a file of its own
function standalone(svg) {
    const copy = svg.cloneNode(true);
    copy.setAttribute("xmlns", SVG);
    make("style", {}, copy, ".axis{stroke:#8a939e}.grid{stroke:#eceff2}.cursor{display:none}"
        + ".tick{font:11px sans-serif;fill:#68717d}");
    return new XMLSerializer().serializeToString(copy);
}
