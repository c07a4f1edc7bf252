# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""results.csv from hard.csv and fuzz.csv; the tables of README.md; a picture."""

import csv
import sys
from collections import Counter

from fsbi import plots
from fsbi.results import Results

quick = sys.argv[1] == "true"
VERDICTS = ["right", "stopped", "crash", "nan", "silent", "timeout"]
results = Results("B8")


def read(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def hard(rows):
    for row in rows:
        name = f"{row['name']} {row['quantity']}".replace(" ", "_").replace(",", "")
        value, bound = float(row["value"]), float(row["bound"])
        cost = dict(seconds=float(row["seconds"]))
        if row["quantity"] == "ends as it must":
            results.at_least(row["name"] + "_ends_as_it_must", value, 1, **cost)
        elif row["sense"] == "<":
            results.add(name + "_abs", value, 0, bound, **cost)
        else:
            results.at_least(name, value, bound, **cost)


def fuzz(rows):
    found = Counter(row["verdict"] for row in rows)
    results.at_least("fuzz_right", found["right"], 1)
    for verdict in VERDICTS[2:]:
        results.add(f"fuzz_{verdict}_abs", found[verdict], 0, 0)
    return found


def hard_table(rows):
    lines = ["| case | must show | came out |", "|---|---|---|"]
    for name in dict.fromkeys(row["name"] for row in rows):
        mine = [row for row in rows if row["name"] == name]
        ended = mine[0]["verdict"]
        if ended != "right":
            ended += f": {mine[0]['why'].split('Saved states')[0][:160].strip()}"
        numbers = "; ".join(f"{r['quantity']} {float(r['value']):.2g} ({r['sense']} "
                            f"{float(r['bound']):g})" for r in mine[1:])
        shown = f"{ended}{'; ' if numbers else ''}{numbers}".replace("|", "/")
        lines.append(f"| {name} | {mine[0]['shows']} | {shown} |")
    return lines


def fuzz_table(rows, found):
    lines = ["| verdict | scenes |", "|---|---|"]
    lines += [f"| {verdict} | {found[verdict]} |" for verdict in VERDICTS]
    lines += ["", "Those that stopped, and why:", "", "| seed | scene | message |", "|---|---|---|"]
    for row in rows:
        if row["verdict"] != "right":
            why = row["why"].split("Saved states")[0].split(" file: ")[0].replace("|", "/")
            lines.append(f"| {row['seed']} | {row['scene']} | {why[:170].strip()} |")
    return lines


def fill(tag, lines):
    start, end = f"<!-- {tag} -->", f"<!-- /{tag} -->"
    with open("README.md") as file:
        before, _, rest = file.read().partition(start)
    after = rest.partition(end)[2]
    with open("README.md", "w") as file:
        file.write(before + start + "\n" + "\n".join(lines) + "\n" + end + after)


def draw(found, rows):
    figure, axes = plots.plt.subplots(figsize=(7, 2.6))
    axes.barh(VERDICTS[::-1], [found[v] for v in VERDICTS[::-1]], color=plots.COLOURS[0])
    for i, verdict in enumerate(VERDICTS[::-1]):
        axes.text(found[verdict] + 1, i, str(found[verdict]), va="center")
    axes.set(xlabel=f"scenes of {len(rows)}")
    axes.set_title("Random scenes: how they ended", loc="left")
    plots.save(figure, "verdicts.png")


cases, scenes = read("hard.csv"), read("quick.csv" if quick else "fuzz.csv")
hard(cases)
verdicts = fuzz(scenes)
if not quick:
    fill("hard", hard_table(cases))
    fill("fuzz", fuzz_table(scenes, verdicts))
    draw(verdicts, scenes)
results.write()
