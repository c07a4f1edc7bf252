# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The command line of a study: what cannot be used is told in one line, and SIGTERM,
as batch systems send it, ends a study as Ctrl-C does."""

import argparse
import signal
import sys

from . import Refused


class Parser(argparse.ArgumentParser):
    def __init__(self, program, usage):
        super().__init__(prog=program, usage=usage, allow_abbrev=False,
                         formatter_class=argparse.RawTextHelpFormatter)
        self.add_argument("-help", action="help", help=argparse.SUPPRESS)
        self.add_argument("case")
        self.add_argument("--jobs", type=int, default=1)

    def error(self, message):
        raise Refused(message + "; --help tells more")

    def parse_args(self, arguments):
        given = super().parse_args(arguments)
        if given.jobs < 1:
            raise Refused("--jobs is above zero")
        return given


def run(program, main):
    """main(arguments) as this program."""
    signal.signal(signal.SIGTERM, _interrupt)
    try:
        main(sys.argv[1:])
    except Refused as error:
        sys.exit(f"{program}: {error}")


def stopped(done, of, what="runs"):
    """After Ctrl-C."""
    print(f"\nstopped; {done} of {of} {what} are kept, the same command goes on")
    sys.exit(130)


def _interrupt(*_):
    raise KeyboardInterrupt
