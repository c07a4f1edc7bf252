# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""results.csv from hard.csv and fuzz.csv; the tables of README.md; a picture."""

import csv
import sys
from collections import Counter

import numpy as np

from fsbi import plots
from fsbi.results import Results

quick = sys.argv[1:2] == ["true"]
VERDICTS = ["right", "stopped", "crash", "nan", "silent", "timeout"]
results = Results("B8")


def read(path):
    with open(path) as file:
        return list(csv.DictReader(file))


def hard(rows, order=""):
    # bound: said beside each in hard.py
    for row in rows:
        case = row["name"] + order
        name = f"{case} {row['quantity']}".replace(" ", "_").replace(",", "")
        value, bound = float(row["value"]), float(row["bound"])
        cost = dict(seconds=float(row["seconds"]))
        if row["quantity"] == "ends as it must":
            results.at_least(case + "_ends_as_it_must", value, 1, **cost)
        elif row["sense"] == "<":
            results.add(name + "_abs", value, 0, bound, **cost)
        else:
            results.at_least(name, value, bound, **cost)


def doctored(rows):
    # bound: every change made to a history is seen by its law
    results.at_least("doctored_histories_seen", sum(int(row["caught"]) for row in rows),
                     len(rows))


def fuzz(rows):
    found = Counter(row["verdict"] for row in rows)
    must = [row for row in rows if not row["may stop"]]
    bad = [row for row in rows if row["may stop"].startswith("bad input")]
    # bound: what the scene says before it is run (fuzz.py, may_stop): if it gives no
    # reason to stop, the run ends right; if it is wrong, it is refused
    results.at_least("fuzz_right", found["right"], max(1, len(must)))
    results.add("fuzz_stopped_without_reason_abs",
                sum(row["verdict"] == "stopped" for row in must), 0, 0)
    results.add("fuzz_bad_input_computed_abs",
                sum(row["verdict"] != "stopped" for row in bad), 0, 0)
    for verdict in VERDICTS[2:]:
        # bound: never
        results.add(f"fuzz_{verdict}_abs", found[verdict], 0, 0)
    if not quick:
        # bound: of the scenes as they are drawn, a quarter has effects on an elastic
        # body, 6 % gradients or magnets that act on each other, and a run in twenty is
        # too slow: 0.36, and two standard deviations of so many draws
        share = len(partly(rows)) / found["right"]
        results.add("fuzz_share_partly_judged_abs", share, 0,
                    0.36 + 2 * np.sqrt(0.36 * 0.64 / found["right"]))
    return found


def pressed(rows):
    """bound: all end right, as issue and README say: no gap, mesh or Newton is a reason to
    stop, contact keeps the surfaces apart, and a fluid at rest only takes energy."""
    found = Counter(row["verdict"] for row in rows)
    results.at_least("pressed_right", found["right"], len(rows))
    for verdict in VERDICTS[1:]:
        results.add(f"pressed_{verdict}_abs", found[verdict], 0, 0)
    return found


def partly(rows):
    return [row for row in rows if row["judged"] == "partly"]


def reasons(rows):
    reasons = Counter(reason for row in partly(rows) for reason in row["why"].split("; "))
    return ", ".join(f"{reason} ({n})" for reason, n in reasons.most_common())


def judged(rows, found):
    """For the README."""
    must = sum(not row["may stop"] for row in rows)
    bad = sum(row["may stop"].startswith("bad input") for row in rows)
    return [f"Of {len(rows)} scenes {must} gave no reason to stop and {bad} were drawn wrong. "
            f"Of the {found['right']} that ended right {found['right'] - len(partly(rows))} "
            f"were judged by every law, {len(partly(rows))} not by all of them: {reasons(rows)}."]


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
    kinds = Counter(kind_of(row["may stop"]) for row in rows if row["verdict"] == "stopped")
    lines += ["", *judged(rows, found), "", "Those that stopped, by what was known before "
              "(their messages are in `fuzz.csv`): " +
              ", ".join(f"{kind} ({n})" for kind, n in kinds.most_common()) + "."]
    wrong = [row for row in rows if row["verdict"] not in VERDICTS[:2]]
    if wrong:
        lines += ["", "| seed | scene | verdict | why |", "|---|---|---|---|"]
    for row in wrong:
        lines.append(f"| {row['seed']} | {row['scene']} | {row['verdict']} "
                     f"| {row['why'].replace('|', '/')[:170].strip()} |")
    return lines


def kind_of(known):
    """What of a reason to stop has no numbers or names."""
    kinds = {"bad input": "bad input", "may go": "a body may go farther than it has room",
             "across": "springs from the start", "a gap": "a narrow gap",
             "pressed": "an elastic body pressed by a fifth of its modulus"}
    return next((kind for word, kind in kinds.items() if word in known), "nothing")


def pressed_table(rows, found):
    wrong = [row for row in rows if row["verdict"] != "right"]
    lines = [f"Of {len(rows)} scenes {found['right']} ended right, {len(wrong)} did not. By "
             f"every law {found['right'] - len(partly(rows))} were judged, "
             f"{len(partly(rows))} not by all of them: {reasons(rows)}.", "",
             "| seed | scene | verdict | message |", "|---|---|---|---|"]
    for row in wrong:
        why = row["why"].split("Saved states")[0].replace("|", "/")
        lines.append(f"| {row['seed']} | {row['scene']} | {row['verdict']} "
                     f"| {why[:170].strip()} |")
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
        axes.text(found[verdict] + len(rows) / 100, i, str(found[verdict]), va="center")
    axes.set(xlabel=f"scenes of {len(rows)}")
    axes.set_title("Random scenes: how they ended", loc="left")
    plots.save(figure, "verdicts.png")


def main():
    cases, scenes = read("hard.csv"), read("quick.csv" if quick else "fuzz.csv")
    hard(cases)
    fourth = read("hard4.csv")
    hard(fourth, "_order4")
    doctored(read("doctored.csv"))
    verdicts = fuzz(scenes)
    near = read("quickPressed.csv" if quick else "pressed.csv")
    apart = pressed(near)
    if not quick:
        fill("hard", hard_table(cases))
        fill("hard4", hard_table([row for row in fourth if row["verdict"] != "right"]))
        fill("fuzz", fuzz_table(scenes, verdicts))
        fill("pressed", pressed_table(near, apart))
        draw(verdicts, scenes)
    results.write()


if __name__ == "__main__":
    main()
