# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""variants.csv and report.md of a study."""

import csv

import numpy as np

from fsbi.studies.spread import duration


def table(study, path):
    """One row a variant, failed ones too."""
    names = [q.text for q in study.quantities]
    header = ["variant", *(k.name for k in study.parameters), *names,
              *("error of " + n for n in names), "error", "seconds", "wall", "megabytes",
              "cells", "steps", "meshes", "predicted", "predictedMegabytes", "predictedBy",
              "contended", "failed"]
    with open(path, "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        for v in (*study.variants, *study.extra):
            writer.writerow(_row(study, v))


def _row(study, v):
    settings = [v.settings[k.name] for k in study.parameters]
    if not v.done():
        return [v.name, *settings, *[""] * (2 * len(study.quantities) + 11),
                v.failed or "not run"]
    r = v.record
    return [v.name, *settings, *(f"{x:.10g}" for x in v.values),
            *(f"{e:.4g}" for e in v.errors), f"{v.error:.4g}", f"{r['seconds']:.3f}",
            f"{r['wall']:.3f}", f"{r['megabytes']:.1f}", r["cells"], r["steps"], r["meshes"],
            f"{r['predicted']:.3f}" if r.get("predicted") else "",
            f"{r['predictedMegabytes']:.1f}" if r.get("predicted") else "",
            r.get("predictedBy", ""), "yes" if r["contended"] else "no", ""]


def text(study, accuracy, advice, half, verified):
    """The whole report.md."""
    lines = ["# What accuracy costs", "",
             "One parameter at a time around the case as it is; factors multiply what the "
             "case has. Seconds are those of the processor, memory is the most the "
             "process had.", ""]
    lines += _recommendation(study, accuracy, advice, half, verified) + [""]
    lines += _variants(study) + [""] + _parameters(study) + [""] + _honesty(study)
    return "\n".join(lines) + "\n"


def settings_of(study, advice):
    changed = [f"{k} {v}" for k, v in advice.settings.items() if v != study.base[k]]
    return ", ".join(changed) or "the case as it is"


def _recommendation(study, accuracy, advice, half, verified):
    base = study.variants[0]
    lines = [f"The case as it is: error {base.error:.2g}, "
             f"{duration(base.record['seconds'])}, {base.record['megabytes']:.0f} MB.", ""]
    if advice is None:
        floor = max(np.array(study.floor) / study.scale)
        why = (f"; {floor:.2g} of it does not depend on these parameters (domain, model, or "
               "the reference)" if floor > 0.5 * accuracy else "")
        return lines + [f"**No settings of these parameters reach {accuracy:g}**: the least is "
                        f"{study.reachable():.2g}{why}."]
    lines += [f"**For an error of {accuracy:g} take: {settings_of(study, advice)}**: "
              f"predicted {duration(advice.seconds)}, {advice.megabytes:.0f} MB, "
              f"error {advice.error:.2g} (the parameters' errors added up)."]
    if verified is not None:
        lines += [f"Run: {duration(verified.record['seconds'])}, "
                  f"{verified.record['megabytes']:.0f} MB, error {verified.error:.2g}."
                  if verified.done() else f"Run: failed, {verified.failed}."]
    least = study.cheapest(accuracy)
    if least and least is not verified:
        lines += [f"Cheapest of the runs within it: {least.name}, "
                  f"{duration(least.record['seconds'])}, error {least.error:.2g}."]
    if half is None:
        lines += [f"Half that error, {accuracy / 2:g}, is out of reach of these parameters; "
                  f"the least is {study.reachable():.2g}."]
    else:
        lines += [f"Half that error, {accuracy / 2:g}, would take "
                  f"{settings_of(study, half)}: {duration(half.seconds)}, "
                  f"{half.seconds / advice.seconds:.2g} times as long."]
    return lines


def _variants(study):
    lines = ["| variant | error | seconds | predicted | MB | cells | steps | |",
             "|---|---|---|---|---|---|---|---|"]
    front = study.pareto("seconds")
    for v in (*study.variants, *study.extra):
        if not v.done():
            lines.append(f"| {v.name} | | | | | | | {v.failed or 'not run'} |")
            continue
        r = v.record
        notes = ["none better for its time"] if v in front else []
        notes += ["contended"] if r["contended"] else []
        predicted = f"{r['predicted']:.3g}" if r.get("predicted") else ""
        lines.append(f"| {v.name} | {v.error:.2g} | {r['seconds']:.3g} | {predicted} | "
                     f"{r['megabytes']:.0f} | {r['cells']} | {r['steps']} | "
                     f"{', '.join(notes)} |")
    return lines


def _parameters(study):
    lines = ["| quantity | parameter | limit | ± | order | its error as it is | behaviour |",
             "|---|---|---|---|---|---|---|"]
    for i, q in enumerate(study.quantities):
        value, scale = study.variants[0].values[i], study.scale[i]
        for k in study.parameters:
            e = study.limits[i][k.name]
            if e:
                order = f"{e.order:.2f}" if np.isfinite(e.order) else ""
                lines.append(f"| {q.label} | {k.name} | {e.limit:.8g} | "
                             f"{e.uncertainty:.2g} | {order} | "
                             f"{abs(value - e.limit) / scale:.2g} | {e.kind} |")
    return lines


def _honesty(study):
    lines = []
    for i, q in enumerate(study.quantities):
        best = f"{q.label}: errors are relative to {study.best[i]:.8g}"
        if study.references[i] is None:
            lines.append(f"- {best}, estimated, uncertain by {study.unsure[i] / study.scale[i]:.1g}"
                         " of it: smaller errors mean nothing.")
        else:
            lines.append(f"- {best}, given. What the runs tend to is "
                         f"{study.floor[i] / study.scale[i]:.2g} away from it, known to "
                         f"{study.unsure[i] / study.scale[i]:.1g}.")
    if study.scattered():
        lines.append(f"- Not in the range where errors follow one power: {study.scattered()}. "
                     "Their limits are rough, see ±.")
    good, made, guesses = study.within()
    if made:
        lines.append(f"- Predicted within a factor of 1.5: {good} of {made} runs"
                     + (f" ({guesses} of them guesses, of words never tried)" if guesses else "")
                     + ".")
    return lines
