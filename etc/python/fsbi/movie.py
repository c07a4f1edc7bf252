# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A film of a case: one picture of every saved time, all with one camera.

    fsbiMovie CASE --bodies cell --output cell.mp4 [options of picture]

The camera stands where it would for the last time's picture, unless --focus says
otherwise; --follow BODY moves it along with a body. Colours are the same in all
pictures: give --range, or they span what the first and last time have.
An .mp4 is made by ffmpeg; without it, or by the output's name, it is a .gif.
"""

import os
import shutil
import subprocess
import sys
import tempfile

import numpy as np
from PIL import Image

from fsbi import cuts, picture, pictures, vtk_files


def options_of():
    p = picture.options_of("fsbiMovie")
    p.description = __doc__.split("\n\n")[0]
    p.epilog = __doc__.split("\n\n", 2)[2]
    p.add_argument("--fps", type=float, default=10, help="pictures a second")
    p.add_argument("--follow", metavar="BODY", help="keep this body in the middle")
    p.set_defaults(output="movie.mp4", time="all")
    return p


def same_colours(options, states):
    """The range of the colours of the first and the last picture together."""
    if options.range or options.no_cut:
        return
    ends = []
    for state in (states[0], states[-1]):
        scene = picture.Scene(options, state)
        scene.fill()
        ends.append(scene.bars[0][1])
    options.range = [min(e[0] for e in ends), max(e[1] for e in ends)]


def same_tensions(options, states):
    if options.bonds and not options.bond_range:
        bonds = [vtk_files.saved_drawing(options.case, s.time, "bonds.vtk") for s in states]
        options.bond_range = options.bond_scale * max(
            cuts.largest_tension(b) for b in bonds if b is not None)


def frames(options, states, folder):
    """One picture a state; returns their files."""
    view = picture.view_of(options, states[-1])
    start = cuts.middle(states[-1].patch(options.follow)) if options.follow else None
    made = []
    for k, state in enumerate(states):
        shift = cuts.middle(state.patch(options.follow)) - start if options.follow else 0
        made.append(picture.drawn(options, state, view, shift))
        print(f"\r    {k + 1} of {len(states)} pictures", end="", flush=True)
    print()
    boxes = np.array([picture.ink(pixels) for pixels, _, _ in made])
    box = (*boxes.min(axis=0)[[0]], *boxes.max(axis=0)[[1]],
           *boxes.min(axis=0)[[2]], *boxes.max(axis=0)[[3]])
    files = []
    for k, (pixels, bars, title) in enumerate(made):
        options.output = os.path.join(folder, f"{k:05d}.png")
        picture.page(picture.trim(pixels, box), bars, options, title)
        image = Image.open(options.output).convert("RGB")
        # what mp4 wants
        image.crop((0, 0, *(n - n % 2 for n in image.size))).save(options.output)
        files.append(options.output)
    return files


def join(files, output, fps):
    os.makedirs(os.path.dirname(output) or ".", exist_ok=True)
    if output.endswith(".gif"):
        palette = pictures.palette(Image.open(files[-1]))
        first, *others = [Image.open(f).quantize(palette=palette) for f in files]
        first.save(output, save_all=True, append_images=others, loop=0,
                   duration=round(1000 / fps), optimize=True)
        return
    pattern = os.path.join(os.path.dirname(files[0]), "%05d.png")
    subprocess.run(["ffmpeg", "-y", "-loglevel", "error", "-framerate", str(fps), "-i", pattern,
                    "-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", output], check=True)


def main():
    options = options_of().parse_args()
    output = options.output
    if not output.endswith((".gif", ".mp4")):
        sys.exit("fsbiMovie: --output must end in .mp4 or .gif")
    if output.endswith(".mp4") and not shutil.which("ffmpeg"):
        output = output[:-len("mp4")] + "gif"
        print(f"    there is no ffmpeg: {output} instead", file=sys.stderr)
    try:
        with vtk_files.VTKFiles(options.case, options.region, picture.fields_of(options),
                                "all") as states, tempfile.TemporaryDirectory() as folder:
            if len(states) < 2:
                raise vtk_files.NoStates("one saved time only: lessen writeInterval")
            same_colours(options, states)
            same_tensions(options, states)
            join(frames(options, states, folder), output, options.fps)
    except (vtk_files.NoStates, ValueError, subprocess.CalledProcessError) as error:
        sys.exit(f"fsbiMovie: {error}")
    print(f"    {output}")


if __name__ == "__main__":
    main()
