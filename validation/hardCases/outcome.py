# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Run a scene and say how it ended:

    right       every law that must hold of the recorded run holds
    stopped     one message says why, and the saved states continue
    crash       a signal, a stack trace, a PETSc, HDF5, gmsh or Python error
    nan         a number that is not finite was recorded
    silent      something is wrong that nothing told
    timeout     too slow
"""

import os
import re
import shutil
import signal
import subprocess
import time

from laws import broken_laws

ALIEN = re.compile(r"printStack|Segmentation|PETSC ERROR|HDF5-DIAG|terminate called"
                   r"|Traceback|sigFpe|sigSegv|corrupted|double free|std::bad_alloc")


class Outcome:
    """skipped: what of a run that is right no law could judge."""

    def __init__(self, verdict, why="", skipped=()):
        self.verdict, self.why, self.skipped = verdict, why, list(skipped)
        self.seconds = 0.0

    def __repr__(self):
        return f"{self.verdict} ({self.seconds:.1f} s) {self.why}"


# A run that a Ctrl-C ends is continued, in so many parts
PARTS = 2


def solve(folder, limit, log="log.fsbiFoam", mode="w"):
    """Exit code. After `limit` seconds of the processor's time, so that a busy machine
    does not matter, a Ctrl-C; after four times that the end."""
    with open(os.path.join(folder, log), mode) as file:
        run = subprocess.Popen(["nice", "fsbiFoam"], cwd=folder, stdout=file,
                               stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        interrupted = False
        while run.poll() is None:
            time.sleep(0.05)
            used = processor_seconds(run.pid)
            if used > 4 * limit:
                run.kill()
            elif used > limit and not interrupted:
                run.send_signal(signal.SIGINT)
                interrupted = True
        return run.returncode


def processor_seconds(pid):
    """0 of a process that has ended."""
    try:
        with open(f"/proc/{pid}/stat") as file:
            fields = file.read().rpartition(")")[2].split()
    except OSError:
        return 0
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def read(folder, log="log.fsbiFoam"):
    with open(os.path.join(folder, log), errors="replace") as file:
        return file.read()


def message(said):
    """The text of the one message, on one line; None if there is no or more."""
    parts = re.split(r"FOAM FATAL (?:IO )?ERROR:?", said)
    if len(parts) != 2:
        return None
    reason = re.split(r"\n\s*From ", parts[1])[0]
    return " ".join(reason.split())


def states(folder):
    """Names of the saved states, by time."""
    names = [n for n in os.listdir(folder) if re.fullmatch(r"[0-9.]+(e[+-]?[0-9]+)?", n)
             and os.path.isdir(os.path.join(folder, n, "uniform"))]
    return sorted(names, key=float)


def continues(folder, limit, why):
    """Empty if the states that a stopped run left are whole: the one before
    the last leads to the last again, to the last bit, and from there the run
    says the same. Otherwise what is wrong."""
    left = [f for _, _, files in os.walk(folder) for f in files
            if f.endswith(".part") or f == "core"]
    if left:
        return f"left {left[0]}"
    saved = states(folder)
    if not saved:
        return ""               # it never began
    again = folder.rstrip("/") + ".again"
    shutil.rmtree(again, ignore_errors=True)
    shutil.copytree(folder, again)
    if len(saved) > 1:
        shutil.rmtree(os.path.join(again, saved[-1]))
    code = solve(again, limit)
    if code in (124, 137, -9):
        return "too slow when continued"
    said = message(read(again))
    if why.startswith("Interrupted"):
        # after seconds, not at an instant of the run: a step may be met then
        if code and said is None:
            return "no single message when continued"
    elif said is None or code == 0:
        return "another end when continued"
    elif normal(said) != normal(why):
        return f"when continued it says: {said[:200]}"
    if len(saved) > 1 and content(folder, saved[-1]) != content(again, saved[-1]):
        return "continued, the state before the last does not lead to the last"
    shutil.rmtree(again)
    return ""


def content(folder, time):
    """Of the state of that time, whatever digits its folder is named with;
    without the header, which holds the name."""
    for name in states(folder):
        if abs(float(name) - float(time)) <= 1e-9 * float(time):
            with open(os.path.join(folder, name, "uniform", "fsbiState")) as file:
                return re.sub(r'location +".*";', "", file.read())
    return ""


def normal(reason):
    """Without paths."""
    return re.sub(r"/\S*/", "", reason)


def judge(scene, folder, limit=300):
    start = time.time()
    scene.write(folder)
    code = solve(folder, limit)
    for _ in range(PARTS - 1):
        if code or "Interrupted at" not in last_part(folder):
            break
        code = solve(folder, limit, mode="a")
    outcome = verdict(scene, folder, code, limit)
    outcome.seconds = time.time() - start
    return outcome


def last_part(folder):
    """What the last of the parts of a run said."""
    return read(folder).rpartition("Continuing from the state")[2]


def verdict(scene, folder, code, limit):
    said = read(folder)
    alien = ALIEN.search(said)
    if code in (124, 137, -9):
        return Outcome("timeout", last_line(said))
    if code < 0 or code > 127 or alien:
        return Outcome("crash", alien.group() if alien else f"exit code {code}")
    if code:
        why = message(said)
        if why is None:
            return Outcome("crash", "no single message")
        damage = continues(folder, limit, why)
        return Outcome("silent", damage) if damage else Outcome("stopped", why)
    if scene.faulty:
        return Outcome("silent", f"accepted: {scene.faulty}")
    return Outcome(*broken_laws(scene, folder, said))


def last_line(said):
    lines = [line for line in said.splitlines() if line.strip()]
    return lines[-1][:150] if lines else ""
