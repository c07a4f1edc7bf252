# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs of variants of a case, in copies, and what is kept of them.

CASE/STUDY/runs/HASH holds run.json (settings, seconds, memory ...), the log,
postProcessing and the extremes of the last fields; the hash is that of the
case's files and the settings, so that a study that was stopped goes on, and one
with another quantity needs no run again. What was stopped is not kept; what a
program failed at by itself would fail again, and a bench that keeps failures has
failed.json (and the log) of it.
"""

import glob
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time

from fsbi.history import History

from . import Refused
from .entries import Entries
from .quantities import summarise_fields

MADE = re.compile(r"log\..*|postProcessing|processors?\d*.*|VTK|pictureVTK|runs|dynamicCode"
                  r"|accuracyCost|ensemble|optimise|reduce|.*\.(png|md|h5.*|py|csv)|Allrun|Allclean"
                  r"|.*\.foam|__pycache__")
# signals by which a person or a batch system ends a program
OUTSIDE = (signal.SIGINT, signal.SIGTERM, signal.SIGKILL, signal.SIGHUP, signal.SIGXCPU)


class Failed(Exception):
    """A variant did not end well; the text says why. again: it would not either if
    it were run again, since nobody ended it."""

    def __init__(self, text, again=False):
        super().__init__(text)
        self.again = again


class Bench:
    """study: name of the folder of what is kept; own: files of the case that belong to
    the study, and do not go with a copy."""

    def __init__(self, case, study, application=None, prepare="blockMesh", fixed=(),
                 longest=None, own=(), keepFailures=False):
        self.case = os.path.normpath(case)
        for file in ("system/controlDict", "constant"):
            if not os.path.exists(os.path.join(case, file)):
                raise Refused(f"'{case}' is no case: it has no {file}")
        self.fixed = list(fixed)        # [(file, entry, value)]
        self.entries = Entries(self.case, self.fixed)
        self.application = application or self.entries.get("system/controlDict", "application")
        if not self.application or not shutil.which(self.application):
            raise Refused(f"the application '{self.application}' of {case}/system/controlDict "
                          "is not there; is etc/bashrc sourced?")
        self.prepare = prepare
        if prepare == "blockMesh" and not glob.glob(self.entries.path("system/blockMeshDict")):
            self.prepare = "true"
        self.longest = longest
        self.own, self.keepFailures = own, keepFailures
        self.folder = os.path.join(self.case, study)
        self.kept = os.path.join(self.folder, "runs")
        self.running = set()            # processes
        self.stopped = False
        self.digest = self._digest()

    # The case

    def files(self):
        """What a copy needs: not the results of runs, no times but the first."""
        return (file for file in self._all() if file not in self.own)

    def _all(self):
        start = "0.orig" if os.path.isdir(self.entries.path("0.orig")) else "0"
        meshed = os.path.isfile(self.entries.path("system/blockMeshDict"))
        for name in sorted(os.listdir(self.case)):
            if MADE.fullmatch(name) or name.startswith("."):
                continue
            if re.fullmatch(r"[0-9.]+(e-?\d+)?|0\.orig", name) and name != start:
                continue
            top = self.entries.path(name)
            if os.path.isfile(top):
                yield name
            for folder, inner, names in os.walk(top):
                if meshed and os.path.basename(folder) == "polyMesh":
                    inner[:] = []
                    continue
                inner.sort()
                for n in sorted(names):
                    yield os.path.relpath(os.path.join(folder, n), self.case)

    def _digest(self):
        sha = hashlib.sha256(f"{self.application} {self.prepare} {self.fixed}".encode())
        for file in self.files():
            sha.update(file.encode())
            with open(self.entries.path(file), "rb") as f:
                sha.update(f.read())
        return sha.hexdigest()

    def hash(self, settings, parameters):
        """Of the case with these settings; those of the case itself are left
        out, so that more parameters do not make it another."""
        keys = sorted(json.dumps(k.key(settings[k.name])) for k in parameters
                      if settings.get(k.name, k.values[k.base]) != k.values[k.base])
        return hashlib.sha256((self.digest + str(keys)).encode()).hexdigest()[:12]

    def copy(self, folder, settings, parameters, part=None):
        for file in self.files():
            to = os.path.join(folder, re.sub(r"^0\.orig/", "0/", file))
            os.makedirs(os.path.dirname(to), exist_ok=True)
            shutil.copy2(self.entries.path(file), to)
        entries = Entries(folder)
        for file, entry, value in self.fixed:
            entries.set(file, entry, value)
        for parameter in parameters:
            parameter.apply(entries, settings.get(parameter.name, parameter.values[parameter.base]))
        if part:
            entries.set("system/controlDict", "endTime", f"{part:.10g}")
        return entries

    def span(self):
        """Start, end and number of steps of the case as it is."""
        start, end, step = (self.entries.number("system/controlDict", e)
                            for e in ("startTime", "endTime", "deltaT"))
        start = start or 0.0
        if end is None or not step:
            return start, None, 1
        return start, end, max(1, round((end - start) / step))

    # Running

    def load(self, settings, parameters):
        """The record of a finished run, or None."""
        return self._record(settings, parameters, "run.json")

    def failure(self, settings, parameters):
        """Why a run failed, if that is kept."""
        record = self._record(settings, parameters, "failed.json")
        return record and record["failed"]

    def _record(self, settings, parameters, name):
        folder = os.path.join(self.kept, self.hash(settings, parameters))
        try:
            with open(os.path.join(folder, name)) as file:
                return dict(json.load(file), folder=folder)
        except (OSError, ValueError):
            return None

    def run(self, settings, parameters, tell=None, **notes):
        """Run and keep; its record. Failed says why it did not end."""
        with tempfile.TemporaryDirectory(prefix="fsbiStudy.") as top:
            folder = os.path.join(top, "case")
            self.copy(folder, settings, parameters)
            try:
                record = dict(settings=settings, **notes, **self._measure(folder, tell))
            except Failed as failure:
                if self.keepFailures and failure.again:
                    self._keep(folder, settings, parameters, dict(failed=str(failure)),
                               "failed.json")
                raise
            return self._keep(folder, settings, parameters, record)

    def calibrate(self, settings, parameters, part=0.15):
        """Seconds of a whole run and megabytes, from a part of its time; None
        if it has too few steps. The first step, with the first mesh, counts
        once; later meshes as often as they were made."""
        start, end, steps = self.span()
        if end is None or steps * part < 2:
            return None
        with tempfile.TemporaryDirectory(prefix="fsbiStudy.") as top:
            folder = os.path.join(top, "case")
            self.copy(folder, settings, parameters, start + part * (end - start))
            found = self._measure(folder, None)
            parts = _parts(os.path.join(folder, f"log.{self.application}"))
            try:
                cost = History(os.path.join(folder, "postProcessing/history.h5"))["cost"]
            except (OSError, KeyError):
                return None
        time, solve, meshes = cost["time"], cost["seconds"], cost["meshes"]
        if len(time) < 2 or not parts:
            return None
        later = (solve[-1] - solve[0]) * (1 + parts["assembly"] / parts["solve"]) \
            + parts["meshing"] * (meshes[-1] - meshes[0]) / meshes[-1]
        whole = found["wall"] + later * (end - time[-1]) / (time[-1] - time[0])
        return whole * found["seconds"] / found["wall"], found["megabytes"]

    def _measure(self, folder, tell):
        self._command(["bash", "-c", self.prepare], folder, "log.prepare")
        begin, before = time.monotonic(), os.getloadavg()[0]
        log = f"log.{self.application}"
        usage = self._command([self.application], folder, log, tell)
        wall = time.monotonic() - begin
        seconds = usage.ru_utime + usage.ru_stime
        path = os.path.join(folder, log)
        parts = _parts(path)
        part = parts["meshing"] / parts["total"] if parts else 0.0
        return dict(seconds=seconds, wall=wall, megabytes=usage.ru_maxrss / 1024,
                    meshing=part * seconds, load=round(before, 2), **_sizes(folder, path))

    def _command(self, command, folder, log, tell=None):
        """Run in a session of its own; its use of resources by wait4, which has
        the greatest memory of this process alone."""
        if self.stopped:
            raise Failed("stopped")
        with open(os.path.join(folder, log), "wb") as out:
            process = subprocess.Popen(command, cwd=folder, stdout=out, stderr=out,
                                       stdin=subprocess.DEVNULL, start_new_session=True)
        self.running.add(process)
        begin = time.monotonic()
        try:
            status, usage, why = self._wait(process, begin, os.path.join(folder, log), tell)
        except BaseException:
            self._kill(process)
            raise
        finally:
            self.running.discard(process)
        with open(os.path.join(folder, log), errors="replace") as file:
            text = file.read()
        if status:
            raise Failed(why or _reason(command[0], text, status),
                         again=not why and status & 127 not in OUTSIDE)
        if ended := re.search(r"^Interrupted at .*", text, re.M):
            raise Failed(f"{command[0]}: {ended[0]}")       # which it calls success
        return usage

    def _wait(self, process, begin, log, tell):
        why = None
        while True:
            pid, status, usage = os.wait4(process.pid, os.WNOHANG)
            if pid:
                process.returncode = status
                return status, usage, why
            passed = time.monotonic() - begin
            if self.longest and passed > self.longest and not why:
                why = f"ended after {self.longest:g} s, the longest allowed"
                os.killpg(process.pid, signal.SIGKILL)
            if tell and passed > 2:
                tell(_progress(log))
            time.sleep(0.02 if passed < 2 else 0.2)

    def _kill(self, process):
        if process.returncode is None:
            try:
                os.killpg(process.pid, signal.SIGKILL)
                os.wait4(process.pid, 0)
            except (ProcessLookupError, ChildProcessError):
                pass
            process.returncode = -9

    def stop(self):
        """End what runs, and let nothing else begin."""
        self.stopped = True
        for process in list(self.running):
            try:
                os.killpg(process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def _keep(self, folder, settings, parameters, record, name="run.json"):
        to = os.path.join(self.kept, self.hash(settings, parameters))
        shutil.rmtree(to, ignore_errors=True)
        os.makedirs(to)
        if os.path.isdir(os.path.join(folder, "postProcessing")):
            shutil.copytree(os.path.join(folder, "postProcessing"),
                            os.path.join(to, "postProcessing"))
        for log in glob.glob(os.path.join(folder, "log.*")):
            shutil.copy2(log, to)
        summarise_fields(folder, to)
        with open(os.path.join(to, "run.part"), "w") as file:
            json.dump(record, file, indent=1)
        # last, and at once: a kept run is a whole one
        os.replace(os.path.join(to, "run.part"), os.path.join(to, name))
        return dict(record, folder=to)


def _parts(log):
    """The closing table of a log, seconds per part; empty if there is none."""
    with open(log, errors="replace") as file:
        found = re.findall(r"^ *(meshing|assembly|solve|total) +([0-9.]+) s", file.read(), re.M)
    parts = {name: max(float(value), 1e-3) for name, value in found}
    return parts if len(parts) == 4 else {}


def _sizes(folder, log):
    """Cells, steps and meshes of a run, where it tells them."""
    try:
        cost = History(os.path.join(folder, "postProcessing/history.h5"))["cost"]
        return dict(cells=int(cost["cells"].max()), steps=len(cost),
                    meshes=int(cost["meshes"].max()))
    except (OSError, KeyError):
        with open(log, errors="replace") as file:
            cells = re.search(r"Cells: (\d+)", file.read())
        return dict(cells=int(cells[1]) if cells else 0, steps=0, meshes=0)


def _progress(log):
    with open(log, "rb") as file:
        file.seek(max(0, os.path.getsize(log) - 2000))
        found = re.findall(rb"([0-9.]+) %  left", file.read())
    return float(found[-1]) / 100 if found else 0.0


def _reason(command, text, status):
    """A line or two of the end of a log."""
    error = re.search(r"--> FOAM FATAL.*?:\s*\n+(.*?)(\n\n|\Z)", text, re.S)
    lines = (error[1] if error else text).strip().splitlines()
    last = " ".join(t.strip() for t in (lines[:3] if error else lines[-2:]))
    how = f"signal {status & 127}" if status & 127 else f"exit code {status >> 8}"
    return f"{command} stopped with {how}: {last}"[:400]
