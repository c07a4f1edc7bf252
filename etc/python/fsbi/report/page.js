// fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the page together from its numbers.

const data = JSON.parse(document.getElementById("data").textContent);

// Columns of a table that share a unit are one chart; returns the titles of
// those that are left out, as all of them is zero
function tableCharts(parent, table, title) {
    const zero = [];
    const groups = new Map();
    table.columns.slice(1).forEach((name, i) => {
        const unit = table.units[i + 1];
        const stem = unit === "-" ? name : name.replace(/^(.*?[a-zA-Z])[xyz]$/, "$1");
        const key = new Set(table.units.slice(1)).size === 1 ? "" : `${unit} ${stem}`;
        if (!groups.has(key)) groups.set(key, { unit, names: [], series: [] });
        groups.get(key).names.push(stem);
        groups.get(key).series.push({ name, y: table.values[i + 1] });
    });
    for (const group of groups.values()) {
        const what = groups.size > 1 ? `${title}: ${group.names[0]}` : title;
        if (group.series.every(s => s.y.every(v => v === 0))) {
            zero.push(what);
            continue;
        }
        chart(parent, { title: what, unit: group.unit, x: table.values[0], xUnit: data.time,
            series: group.series });
    }
    if (table.recorded > table.values[0].length) {
        make("p", {}, parent, `${title}: ${table.values[0].length} of ${table.recorded} rows are shown.`);
    }
    return zero;
}

function curves() {
    const section = document.getElementById("curves");
    const heads = new Map();
    const zeros = new Map();
    const rank = table => table.path.startsWith("effects/") ? 1 : 0;
    for (const table of [...data.tables].sort((a, b) => rank(a) - rank(b))) {
        const parts = table.path.split("/");
        if (table.path === "cost" || !table.recorded) continue;
        const key = parts.slice(0, 2).join("/");
        if (!heads.has(key)) {
            const name = parts[0] === "effects" ? `Effect ${parts[1]}` : parts[1];
            make("h3", {}, section, name);
            heads.set(key, make("div", { class: "charts" }, section));
            zeros.set(key, make("p", { class: "zeros" }, section));
        }
        const zero = tableCharts(heads.get(key), table, parts.slice(2).join(" ") || parts[1]);
        const line = zeros.get(key);
        zero.forEach(name => {
            line.textContent += (line.textContent ? ", " : "Zero throughout: ") + name;
        });
    }
}

function stepCurves() {
    const box = make("div", { class: "charts" }, document.getElementById("stepCurves"));
    const tried = data.tried;
    const only = flag => tried.length.map((l, i) => tried.accepted[i] === flag ? l : null);
    if (tried.time.length) {
        const series = [{ name: "accepted", y: only(true) }];
        if (tried.accepted.includes(false)) {
            series.push({ name: "rejected", y: only(false), dots: true, colour: "#b2182b" });
        }
        chart(box, { title: "step length", unit: data.time, x: tried.time, xUnit: data.time, series, log: true });
        chart(box, { title: "residual", unit: "-", x: tried.time, xUnit: data.time, log: true,
            series: [{ name: "of each step tried", y: tried.residual }] });
    }
    const cost = data.tables.find(t => t.path === "cost");
    const titles = { iterations: "Krylov iterations", corrections: "Newton iterations",
        cells: "cells", meshes: "meshes made", seconds: "seconds of solution, summed" };
    for (const [name, title] of Object.entries(titles)) {
        const i = cost ? cost.columns.indexOf(name) : -1;
        if (i > 0 && cost.values.length) {
            chart(box, { title, unit: "-", x: cost.values[0], xUnit: data.time,
                series: [{ name, y: cost.values[i] }] });
        }
    }
}

function costBars() {
    const box = document.getElementById("costBars");
    if (!data.seconds.length) {
        make("p", {}, box, "The run has no seconds by part.");
        return;
    }
    const seconds = data.seconds.slice(1).map(column => column[0]);
    const total = seconds[seconds.length - 1];
    const parts = data.parts.slice(0, -1).map((name, i) => [name, seconds[i]]);
    parts.push(["other", Math.max(0, total - parts.reduce((sum, p) => sum + p[1], 0))]);
    for (const [name, s] of [...parts, ["total", total]]) {
        const row = make("div", { class: "bar", "data-part": name, "data-seconds": s }, box);
        make("span", {}, row, name);
        make("i", { style: `width:${100 * s / total}%` }, row);
        make("span", {}, row, `${s.toFixed(2)} s  ${(100 * s / total).toFixed(1)} %`);
    }
}

if (!data.tables.some(t => t.recorded)) {
    make("p", {}, document.getElementById("curves"), "Nothing is recorded yet.");
}
curves();
stepCurves();
costBars();
if (data.scene) window.fsbiBodies = bodies(data.scene);
