# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The page: texts from here, curves and bodies by the scripts beside this file
from the numbers that the page carries."""

import base64
import html
import json
import os
from collections import Counter
from datetime import datetime, timezone

import numpy as np

from . import accuracy

HERE = os.path.dirname(os.path.abspath(__file__))
THREE = ("build/three.min.js", "examples/js/controls/OrbitControls.js")
PLACES = ["/usr/share/javascript/three"]
REJECTED_SHOWN = 40


def write(path, run, shown, title=None):
    """Write the page; returns its size in bytes."""
    title = title or os.path.basename(run.case)
    library, missing = _library(shown)
    parts = {
        "TITLE": html.escape(title),
        "STYLE": _file("page.css"),
        "SUMMARY": _summary(run),
        "CALLED": _called(run),
        "DEFAULTS": _rows(("file", "entry", "value"), run.defaults())
        or "<p>The history has no notes of them.</p>",
        "DICTIONARIES": _dictionaries(run),
        "MISSING": html.escape(missing),
        "STEPS": _steps(run),
        "ACCURACY": accuracy.section(run),
        "PICTURES": _pictures(run),
        "ORIGIN": _origin(run),
        "DATA": _json(_data(run, None if missing else shown)),
        "LIBRARY": library,
        "SCRIPT": "\n".join(_file(f) for f in ("charts.js", "bodies.js", "page.js")),
    }
    text = _file("page.html")
    for name, part in parts.items():
        text = text.replace("{{" + name + "}}", part)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return len(text.encode())


def _file(name, folder=HERE):
    with open(os.path.join(folder, name), encoding="utf-8") as file:
        return file.read()


def _library(shown):
    """(three.js to be part of the page, why there is none)."""
    if not shown:
        return "", "Left out, as --no-3d asked."
    if "missing" in shown:
        return "", shown["missing"]
    for folder in [os.environ.get("FSBI_THREE", ""), *PLACES]:
        if folder and all(os.path.isfile(os.path.join(folder, f)) for f in THREE):
            # a script must not end the element that holds it
            return "\n".join(_file(f, folder).replace("</script", "<\\/script")
                             for f in THREE), ""
    return "", ("Not drawn: three.js is not installed. 'apt-get install libjs-three' and"
                " fsbiReport again; elsewhere set FSBI_THREE to a folder of three.js"
                f" r111 with {' and '.join(THREE)}.")


# Numbers

def _json(value):
    return json.dumps(value, separators=(",", ":")).replace("</", "<\\/")


def _number(x):
    return float(f"{x:.9g}") if np.isfinite(x) else None


def _columns(rows):
    return [[_number(x) for x in column] for column in np.asarray(rows, float).T]


def _data(run, shown):
    tables = [{**t, "rows": None, "values": _columns(t["rows"])} for t in run.tables()]
    return {
        "time": run.unit("T"),
        "length": run.unit("L"),
        "force": run.unit("M L/T^2"),
        "bodies": [name for _, name in run.bodies()],
        "tables": tables,
        "tried": {
            "time": [_number(s.time) for s in run.steps],
            "length": [_number(s.length) for s in run.steps],
            "accepted": [s.accepted for s in run.steps],
            "residual": [_number(s.residual) for s in run.steps],
        },
        "parts": run.parts,
        "seconds": _columns(run.seconds[-1:]) if len(run.seconds) else [],
        "scene": shown,
    }


# Texts

def _rows(head, rows):
    if not rows:
        return ""

    def line(cells, tag):
        return "<tr>" + "".join(f"<{tag}>{html.escape(str(c))}</{tag}>" for c in cells) + "</tr>"

    return ("<table>" + line(head, "th") + "".join(line(r, "td") for r in rows) + "</table>")


def _summary(run):
    cost = run.history["cost"]
    facts = [("run", run.status())]
    if len(cost):
        facts += [("steps", f"{len(cost)}, {sum(not s.accepted for s in run.steps)} rejected"),
                  ("cells", f"{int(cost['cells'][-1]):,}".replace(",", " ")),
                  ("meshes", f"{int(cost['meshes'][-1])}")]
    if len(run.seconds):
        facts.append(("wall clock", f"{run.seconds[-1, -1]:.1f} s"))
    facts.append(("processes", ", ".join(run.latest("processes")) or "not noted"))
    return "".join(f"<div><b>{html.escape(v)}</b>{html.escape(k)}</div>" for k, v in facts)


def _called(run):
    bodies = _rows(("body", "kind"), [(n, k) for k, n in run.bodies()])
    effects = ", ".join(run.latest("effects")) or "none"
    events = "".join(f"<p>{n} events are in the history's table {html.escape(p)}.</p>"
                     for p, n in run.events().items())
    return f"{bodies}<p>Effects loaded: <b>{html.escape(effects)}</b></p>{events}"


def _dictionaries(run):
    return "".join(f"<details><summary>{html.escape(name)}</summary>"
                   f"<pre>{html.escape(text)}</pre></details>"
                   for name, text in run.dictionaries())


def _steps(run):
    accepted = [s for s in run.steps if s.accepted]
    rejected = [s for s in run.steps if not s.accepted]
    if not run.steps:
        return "<p>There is no postProcessing/steps: the run is of before these were kept.</p>"
    by = Counter(s.reason for s in accepted)
    length = Counter()
    for s in accepted:
        length[s.reason] += s.length
    unit = run.unit("T")
    limits = _rows(("length limited by", "steps", f"time ({unit})"),
                   [(r, n, f"{length[r]:.6g}") for r, n in by.most_common()])
    why = _rows((f"rejected at ({unit})", f"length ({unit})", "why"),
                [(f"{s.time:g}", f"{s.length:g}", s.reason) for s in rejected[:REJECTED_SHOWN]])
    more = len(rejected) - REJECTED_SHOWN
    why += f"<p>... and {more} more in postProcessing/steps</p>" if more > 0 else ""
    return limits + (why or "<p>No step was rejected.</p>")


def _pictures(run):
    def picture(path):
        with open(path, "rb") as file:
            data = base64.b64encode(file.read()).decode()
        name = html.escape(os.path.basename(path))
        return (f'<figure><img alt="{name}" src="data:image/png;base64,{data}">'
                f"<figcaption>{name}</figcaption></figure>")
    return "".join(picture(p) for p in run.pictures()) or "<p>None in the case's folder.</p>"


def _origin(run):
    rows = [(start, *(", ".join(about.get(k, ["not noted"])) for k in
                      ("begun", "program", "libraries", "processes", "processor")))
            for start, about in run.starts]
    now = datetime.now(timezone.utc).strftime("%Y-%m-%d %H:%M UTC")
    return (_rows((f"from ({run.unit('T')})", "begun (UTC)", "fsbiFoam, commit", "libraries",
                   "processes", "processor"), rows)
            + f"<p>Page of {now}, from {html.escape(run.case)}</p>")
