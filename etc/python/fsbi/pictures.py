# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Small files of pictures: curves (plots), scenes (picture) and films (movie)."""

import os

from PIL import Image


def palette(image):
    """The image in the 256 colours that suit it best, without dithering."""
    return image.quantize(256, method=Image.Quantize.MAXCOVERAGE)


def save(figure, path, limit=150_000):
    """A figure of matplotlib as PNG, in a palette where all colours take more bytes
    than the limit; closes it."""
    from matplotlib import pyplot

    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    figure.savefig(path)
    pyplot.close(figure)
    if os.path.getsize(path) > limit:
        full = Image.open(path).convert("RGB")
        full.quantize(palette=palette(full)).save(path, optimize=True)     # dithered
