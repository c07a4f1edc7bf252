# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Units of a history's columns, by the text that stands beside each table."""

import re

SYSTEMS = {
    # pg µm/µs² is 1e-15 kg 1e-6 m / 1e-12 s²: a nanonewton
    "microvascular": {"L": "µm", "T": "µs", "M": "pg", "M L/T^2": "nN",
                      "M L^2/T^2": "nN µm"},
    "SI": {"L": "m", "T": "s", "M": "kg", "M L/T^2": "N", "M L^2/T^2": "N m"},
    "none": {"L": "L", "T": "T", "M": "M"},
}


def named(unit, system):
    """ "M L/T^2" in a system of units."""
    names = SYSTEMS[system]
    if unit in names:
        return names[unit]
    text = re.sub(r"(?<![A-Za-z])[LTM](?![A-Za-z])", lambda m: names[m.group()], unit)
    return text.replace("^2", "²").replace("^3", "³")


def of_columns(columns, text):
    """Unit of every column besides the time. The text is one unit for all, one
    for each in turn ("L, -, s"), or by name ("B: tesla, f: M L/T^2"), where f
    also stands for fx, fy, fz and for f.anything; "-": none."""
    text = text.split(";")[0].strip()
    if ":" in text:
        by_name = dict(part.split(": ") for part in text.split(", "))
        return [_match(column, by_name) for column in columns]
    parts = text.split(", ")
    return parts if len(parts) == len(columns) else [text] * len(columns)


def _match(column, by_name):
    for name, unit in by_name.items():
        if column in (name, name + "x", name + "y", name + "z") \
                or column.startswith(name + "."):
            return unit
    return "-"
