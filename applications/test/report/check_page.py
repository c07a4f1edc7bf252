# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Does a page hold what the run recorded?

    check_page.py CASE [PAGE]
"""

import base64
import glob
import html
import json
import os
import re
import sys

import h5py
import numpy as np


def numbers(text):
    """The numbers that the page's scripts draw."""
    return json.loads(re.search(
        r'<script id="data" type="application/json">(.*?)</script>', text, re.S).group(1))


def floats(text, width):
    return np.frombuffer(base64.b64decode(text), "<f4").reshape(-1, width)


def check_tables(data, file):
    shown = {t["path"]: t for t in data["tables"]}
    recorded = {}
    file.visititems(lambda path, node: recorded.update({path: node})
                    if isinstance(node, h5py.Dataset) else None)
    once = {p: d for p, d in recorded.items() if b"instant" not in list(d.attrs["columns"])}
    assert set(shown) == set(once), set(shown) ^ set(once)
    for path, node in once.items():
        table, rows = shown[path], node[()]
        assert table["recorded"] == len(rows), path
        assert table["columns"] == [c.decode() for c in node.attrs["columns"]], path
        assert len(table["units"]) == rows.shape[1], path
        np.testing.assert_allclose(np.array(table["values"]).T, rows, rtol=1e-8, err_msg=path)


def check_steps(data, case, text):
    log = open(f"{case}/log.fsbiFoam").read()
    accepted = re.findall(r"^Time = (\S+) +dt (\S+) .* residual +(\S+).*dt by (.*)$", log, re.M)
    assert data["tried"]["accepted"].count(True) == len(accepted) > 1
    np.testing.assert_allclose(data["tried"]["length"], [float(a[1]) for a in accepted], rtol=1e-3)
    np.testing.assert_allclose(data["tried"]["residual"], [float(a[2]) for a in accepted], rtol=0.1)
    for reason in {a[3].split("  ")[0] for a in accepted}:
        count = sum(a[3].split("  ")[0] == reason for a in accepted)
        assert f"<tr><td>{html.escape(reason)}</td><td>{count}</td>" in text, reason
    table = dict(re.findall(r"^    (\S+) +([0-9.]+) s ", log, re.M))
    for part, column in zip(data["parts"], data["seconds"][1:]):
        # what comes after the last step, its saved state, is in the log only
        assert abs(column[0] - float(table[part])) < 0.5 + 0.2 * float(table[part]), part


def check_notes(file, text):
    notes = file["runs/0"].attrs
    for line in notes["defaults"]:
        value = html.escape(line.decode().split(" ", 2)[2])
        assert f"<td>{value}</td>" in text, line
    for name in ("program", "begun", "processor"):
        assert html.escape(notes[name][0].decode()) in text, name
    for name in notes.get("effects", []):
        assert name.decode() in text


def check_bonds(data, case, recorded):
    """Those of every saved state; as many as the history has."""
    scene = data["scene"]
    root = f"{case}/processor0" if os.path.isdir(f"{case}/processor0") else case
    saved = [float(f) for f in os.listdir(root) if re.fullmatch("[1-9][0-9]*", f)]
    for time, frame in zip(scene["times"], scene["bonds"]):
        if time not in saved:
            assert frame is None, time
            continue
        with open(f"{root}/{time:g}/uniform/bonds.vtk") as file:
            words = file.read().split()
        n = int(words[words.index("LINES") + 1])
        assert len(frame["tension"]) == n, time
        if n:
            at = words.index("double") + 1
            np.testing.assert_allclose(floats(frame["ends"], 3),
                                       np.array(words[at:at + 6 * n], float).reshape(-1, 3),
                                       rtol=1e-6, atol=1e-6)
            np.testing.assert_allclose(frame["tension"], np.array(words[-n:], float), rtol=1e-3)
        rows = recorded[recorded[:, 0] <= time * (1 + 1e-9)]
        assert n == rows[-1, 1], (time, n, rows[-1])


def check_bodies(data, case, file):
    """Surfaces stand where the history has the bodies, and while it has them."""
    scene = data["scene"]
    times = np.array(scene["times"])
    for body in scene["bodies"]:
        path = f"bodies/{body['name']}/position"
        rows = file[path if path in file else f"elasticBodies/{body['name']}/centre"][()]
        ways = scene["paths"][body["name"]]
        assert sum(len(floats(way, 3)) for way in ways) == len(rows), body["name"]
        if "motion" in body:
            motion = floats(body["motion"], 7)
            there = ~np.isnan(motion[:, 0])
            assert np.array_equal(times[there], rows[:, 0]), body["name"]
            np.testing.assert_allclose(motion[there, :3], rows[:, 1:], rtol=1e-6)
            continue
        for time, frame in list(zip(times, body["frames"]))[1:]:
            assert (frame is None) == (time not in rows[:, 0]), (body["name"], time)
            if frame is None:
                continue
            centre = floats(frame["points"], 3).mean(axis=0)
            at = rows[np.argmin(abs(rows[:, 0] - time)), 1:]
            size = np.ptp(floats(frame["points"], 3), axis=0).max()
            assert np.linalg.norm(centre - at) < 0.05 * size, (body["name"], time, centre, at)


def check_traffic(data):
    """One is gone at the end, one is not there in the beginning."""
    def there(name):
        body = next(b for b in data["scene"]["bodies"] if b["name"] == name)
        return [f is not None for f in body["frames"]] if "frames" in body \
            else list(~np.isnan(floats(body["motion"], 7)[:, 0]))
    for name, ends in (("first", (True, False)), ("late", (False, True))):
        seen = there(name)
        assert (seen[1], seen[-1]) == ends, (name, seen)
        assert seen.index(ends[1], 1) > 1


def main(case, path=None):
    path = path or f"{case}/report.html"
    assert os.path.getsize(path) < 5e6, os.path.getsize(path)
    assert not glob.glob(f"{case}/vtk*"), "left behind"
    with open(path, encoding="utf-8") as page:
        text = page.read()
    for outside in re.findall(r'(?:src|href)="([^"]*)"', text.split("<script")[0]):
        assert outside.startswith(("#", "data:")), outside
    data = numbers(text)
    with h5py.File(f"{case}/postProcessing/history.h5", "r", swmr=True) as file:
        check_tables(data, file)
        check_steps(data, case, text)
        check_notes(file, text)
        check_bodies(data, case, file)
        if case.startswith("traffic"):
            check_traffic(data)
        if "effects/bonds/selectin" in file:
            check_bonds(data, case, file["effects/bonds/selectin"][()])


if __name__ == "__main__":
    main(*sys.argv[1:])
