# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""One self-contained HTML page of a run of fsbiFoam: what the scene called for
and which defaults were taken, curves of all that was recorded, steps, solver,
cost, versions, and the bodies and bonds in three dimensions.

    fsbiReport CASE [--units microvascular] [--output report.html]

Works while the run goes on, too. The bodies in three dimensions are drawn by
three.js (Debian's libjs-three), which becomes part of the page; without it the
page has everything else and says what to install.
"""

import argparse
import os
import sys

from . import page, scene
from .run import Run
from .units import SYSTEMS


def arguments(argv):
    about, rest = __doc__.split("\n\n", 1)
    p = argparse.ArgumentParser(prog="fsbiReport", description=about, epilog=rest,
                                formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("-help", action="help", help=argparse.SUPPRESS)
    p.add_argument("case", help="folder of the case")
    p.add_argument("--units", default="microvascular", choices=SYSTEMS,
                   help="of the case's numbers (default: microvascular: µm, µs, pg; "
                        "none: L, T, M)")
    p.add_argument("--title", help="default: the name of the case")
    p.add_argument("--output", help="default: report.html in the case")
    p.add_argument("--no-3d", action="store_true", help="leave out the bodies")
    return p.parse_args(argv)


def main(argv=None):
    options = arguments(argv)
    try:
        run = Run(options.case, options.units)
    except (FileNotFoundError, OSError) as error:
        sys.exit(f"fsbiReport: {error}")
    shown = None if options.no_3d else scene.collect(options.case, run)
    output = options.output or os.path.join(options.case, "report.html")
    size = page.write(output, run, shown, options.title)
    print(f"    {output} ({size / 1e6:.1f} MB)")


if __name__ == "__main__":
    main()
