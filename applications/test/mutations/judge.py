# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What became of a mutated case. The rules, in this order:

crash         a program ended by a signal, or printed a stack trace or the
              error of a library (PETSc, HDF5, gmsh, malloc)
memory        more than 4 GB
hang          20 s of computing, or a minute of waiting, without a word
dryRunWrote   files of the case are others after `fsbiFoam -dry-run`
dryRunMissed  the dry run passes, the run itself is refused before two steps
foreign       OpenFOAM's blockMesh, which is not this project's, ends by a signal
              or with a message that would be unclear
refused       exit code not zero and one fatal message, which names the file,
              and of an entry the keyword, what it was changed to, the dictionary
              it is in, or its line (but of the header, of SYNTAX, and of
              what was deleted);
              or what a keyword or the path of a file was misspelt to; or, of
              values that are none of the SLIPS, why a mesh or a step fails
unclear       a message that does not, or more than one
told          accepted, and a line that the unmutated case does not print
              names the entry, or what it was changed to, or the file
legitimate    changes nothing and is on the list of legitimate.py, which says why
swallowed     a slip (SLIPS: misspelt, nan, cut ...) that changes results and
              is not told
different     results of two steps differ from those of the unmutated case
silent        nothing differs, is told, or is on the list

Results are the tables of history.h5 in the rows of the first two steps, and
whatever else the run writes: files, but those that two runs of the unmutated
case write differently.
"""

import hashlib
import os
import re
import shutil

import h5py
import numpy as np

import legitimate
from mutate import HEADER, apply
from program import Program

GOOD = ("refused", "told", "different", "legitimate", "foreign")
BAD = ("crash", "memory", "hang", "dryRunWrote", "dryRunMissed", "unclear", "swallowed",
       "silent")
STEPS = 2

# no reader can take these for what is wanted: to be told, whatever they change
SLIPS = ("misspelt", "value misspelt", "nan", "undefined", "word", "twice", "no semicolon",
         "not opened", "not closed", "comment not closed", "cut", "brace too many",
         "quote not closed", "UTF-16", "empty")

# a reader finds these at the end of the file, or anywhere behind
SYNTAX = ("no semicolon", "not opened", "not closed", "comment not closed")

# a value that is one, but that no step can be computed with
FAILS = re.compile(r"Steps down to .* fail|No acceptable mesh|first step fails")

BROKEN = re.compile(r"printStack|Segmentation|PETSC ERROR|HDF5-DIAG|terminate called"
                    r"|malloc\(|free\(\)|std::bad_alloc", re.M)
FATAL = re.compile(r"-> FOAM FATAL")
NOISE = re.compile(r"^(Date|Time|Host|PID|Case|Exec) +:|^Time = |ExecutionTime| s( |$|,)|MB")


def named(word, text):
    """As a word of its own."""
    return word and re.search(r"(?<![\w-])" + re.escape(word) + r"(?![\w-])", text)


class Result:
    def __init__(self, verdict, why="", seconds=0.0):
        self.verdict, self.why, self.seconds = verdict, " ".join(why.split())[:240], seconds


def history(path):
    """Tables by name, first rows."""
    tables = {}

    def take(name, item):
        if isinstance(item, h5py.Dataset) and item.shape and name.split("/")[0] != "cost":
            tables[name] = hashlib.sha1(np.ascontiguousarray(
                item[:STEPS + 1]).tobytes()).hexdigest()

    with h5py.File(path, "r") as file:
        file.visititems(take)
    return tables


def files(case):
    """Digests of all but logs and the history."""
    found = {}
    for folder, _, names in os.walk(case):
        for name in names:
            path = os.path.join(folder, name)
            if not name.startswith("log.") and name != "history.h5":
                with open(path, "rb") as file:
                    found[os.path.relpath(path, case)] = hashlib.sha1(file.read()).hexdigest()
    return found


def results(case, before):
    """What the run made."""
    made = {name: digest for name, digest in files(case).items()
            if before.get(name) != digest}
    path = os.path.join(case, "postProcessing/history.h5")
    if os.path.isfile(path):
        made.update({"history:" + n: d for n, d in history(path).items()})
    return made


def lines(output):
    """Those that may tell something."""
    return {" ".join(line.split()) for line in output.splitlines()
            if line.strip() and not NOISE.search(line)}


class Judge:
    """Runs mutations of one tutorial, prepared in `base`, in the folder `case`."""

    programs = {}

    def __init__(self, base, case):
        self.base, self.case = base, case
        for name in ("fsbiFoam", "blockMesh"):
            self.programs.setdefault(name, Program(name))
        first, second = self.unmutated(), self.unmutated()
        self.known = first[0] | second[0]
        self.stable = {n: d for n, d in first[1].items() if second[1].get(n) == d}
        self.written = set(first[1])

    def unmutated(self):
        self.fresh()
        before = files(self.case)
        dry = self.fsbi("log.dry", "-dry-run")
        run = self.fsbi("log.run", steps=STEPS)
        if dry.code or run.code:
            raise RuntimeError(f"{self.base} does not run: {(dry.output + run.output)[-600:]}")
        return lines(dry.output) | lines(run.output), results(self.case, before)

    def fresh(self):
        shutil.rmtree(self.case, ignore_errors=True)
        shutil.copytree(self.base, self.case)

    def fsbi(self, log, argument="", steps=None):
        return self.programs["fsbiFoam"].run(self.case, log, argument, steps)

    def judge(self, mutation):
        self.fresh()
        apply(mutation, self.case)
        ended = self.mesh(mutation)
        if ended and (ended.code or ended.stopped):
            return self.stopped(mutation, ended, "blockMesh")
        before = files(self.case)
        dry = self.fsbi("log.dry", "-dry-run")
        broken = self.broken(dry, "dry run")
        if broken:
            return broken
        if files(self.case) != before:
            return Result("dryRunWrote", str(set(files(self.case)) ^ set(before)), dry.seconds)
        if dry.code:
            return self.stopped(mutation, dry, "dry run")
        run = self.fsbi("log.run", steps=STEPS)
        if run.code or self.broken(run, "run"):
            return self.broken(run, "run") or Result(
                "dryRunMissed", self.message(run.output), run.seconds)
        result = self.accepted(mutation, dry.output + (ended.output if ended else ""),
                               run, before)
        result.seconds = dry.seconds + run.seconds
        return result

    def mesh(self, mutation):
        """blockMesh, where the mutation is one of what it reads."""
        if mutation.file not in ("system/blockMeshDict", "system/controlDict") \
                or not os.path.isfile(os.path.join(self.base, "system/blockMeshDict")):
            return None
        for folder, inner, _ in os.walk(os.path.join(self.case, "constant")):
            if "polyMesh" in inner:
                shutil.rmtree(os.path.join(folder, "polyMesh"))
        return self.programs["blockMesh"].run(self.case, "log.blockMesh")

    def broken(self, ended, what):
        """Crash, memory, hang."""
        if ended.stopped in ("memory", "hang"):
            return Result(ended.stopped, f"{what}: {ended.output[-150:]}", ended.seconds)
        if not ended.stopped and (ended.code < 0 or ended.code > 127
                                  or BROKEN.search(ended.output)):
            return Result("crash", f"{what}, code {ended.code}: {self.message(ended.output)}",
                          ended.seconds)
        return None

    def stopped(self, mutation, ended, what):
        """Exit code not zero: is it said why?"""
        unclear = "foreign" if what == "blockMesh" else "unclear"
        broken = self.broken(ended, what)
        if broken:
            broken.verdict = unclear if unclear == "foreign" else broken.verdict
            return broken
        message = self.message(ended.output)
        found = len(FATAL.findall(ended.output))
        lacks = f"{found} messages" if found != 1 else self.lacks(mutation, message)
        return Result(unclear if lacks else "refused",
                      f"{what}: {lacks and lacks + '; '}{message}", ended.seconds)

    @staticmethod
    def message(output):
        """The fatal message, or the end of what was printed."""
        found = re.search(r"-> FOAM FATAL.*?(?=^ *From |\Z)", output, re.S | re.M)
        return found.group() if found else output[-300:]

    def lacks(self, mutation, message):
        """What a message does not name of a mutation."""
        if mutation.kind not in SLIPS and FAILS.search(message):
            return ""
        path = mutation.keyword == "file"
        if (mutation.kind == "misspelt" or path) and named(mutation.new, message):
            return ""
        names = {mutation.file, mutation.file.split("/", 1)[1], *self.includes(mutation.file)}
        if not any(name in message for name in names):
            return "the file is not named"
        words = (*mutation.path, mutation.new)
        if not mutation.path or mutation.path[0] == HEADER \
                or mutation.kind in (*SYNTAX, "deleted") \
                or any(named(word, message) for word in words):
            return ""
        for low, high in re.findall(r"line (\d+)(?: to line (\d+))?", message):
            if int(low) - 1 <= mutation.line <= int(high or low) + 1:
                return ""
        return "the entry is not named"

    def includes(self, file):
        """The files that include it, whose name OpenFOAM gives to its entries."""
        folder, name = os.path.split(file)
        for other in os.listdir(os.path.join(self.base, folder)):
            path = os.path.join(self.base, folder, other)
            if os.path.isfile(path):
                with open(path, encoding="utf-8") as opened:
                    if f'#include "{name}"' in opened.read():
                        yield f"{folder}/{other}"

    def accepted(self, mutation, dry, run, before):
        told = self.told(mutation, dry + run.output)
        if told:
            return Result("told", told)
        if run.stopped == "long":
            return Result("different", "still at work, with words")
        made = results(self.case, before)
        differing = sorted(n for n in set(made) | self.written
                           if n in self.stable and made.get(n) != self.stable[n]
                           or (n in made) != (n in self.written))
        if not differing:
            reason = legitimate.reason(mutation)
            return Result("legitimate" if reason else "silent", reason)
        tables = [n for n in differing if n.startswith("history:")]
        slip = mutation.kind in SLIPS and not legitimate.name(mutation)
        verdict = "swallowed" if slip else "different"
        return Result(verdict, (tables or differing)[0])

    def told(self, mutation, output):
        """The line that tells of it."""
        words = [mutation.file, mutation.file.split("/")[-1]]
        if mutation.path:
            words = [mutation.keyword, mutation.new]
        for line in sorted(lines(output) - self.known):
            if any(named(word, line) for word in words):
                return line
        return ""
