# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a command; append its processor's seconds, wall's and megabytes to a file.

    python3 timed.py costs.csv fsbiFoam

Output of the command goes where that of this script goes.
"""

import os
import subprocess
import sys
import time


def main():
    start = time.perf_counter()
    process = subprocess.Popen(sys.argv[2:])
    _, status, used = os.wait4(process.pid, 0)
    wall = time.perf_counter() - start
    with open(sys.argv[1], "a") as file:
        file.write(f"{used.ru_utime + used.ru_stime:.3f},{wall:.3f},"
                   f"{used.ru_maxrss / 1024:.1f}\n")
    return os.waitstatus_to_exitcode(status)


if __name__ == "__main__":
    sys.exit(main())
