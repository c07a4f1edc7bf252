# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A program run many times, watched: silence, memory, steps.

The libraries are loaded once (forkServer.c); what is run is the program itself.
"""

import os
import re
import resource
import select
import signal
import shutil
import subprocess
import time
from dataclasses import dataclass

HERE = os.path.dirname(os.path.abspath(__file__))
SERVER = os.path.join(HERE, "forkServer.so")

SILENCE = 20            # s of computing without a word; a hang
BLOCKED = 60            # s of waiting without a word; a hang, too
LONGEST = 40            # s of computing with words: seen enough
MEMORY = 4e6            # kB
TICKS = os.sysconf("SC_CLK_TCK")
STEP = re.compile(rb"^Time = [-+0-9.e]+ +dt ", re.M)


@dataclass
class Ended:
    code: int           # exit code, or minus the signal
    output: str
    seconds: float
    stopped: str = ""   # why the test itself ended it: hang, memory, long


def build():
    """The library that is preloaded."""
    source = os.path.join(HERE, "forkServer.c")
    if not os.path.isfile(SERVER) or os.path.getmtime(SERVER) < os.path.getmtime(source):
        subprocess.run(["gcc", "-O2", "-shared", "-fPIC", "-o", SERVER, source, "-ldl"],
                       check=True)


class Program:
    """One at a time: `run` waits for its end."""

    def __init__(self, name):
        self.name = shutil.which(name) or name
        self.process = None

    def start(self):
        ask, self.requests = os.pipe()
        self.answers, answer = os.pipe()
        environment = dict(os.environ, LD_PRELOAD=SERVER, OMPI_MCA_ess_singleton_isolated="1")

        def wire():
            # by way of numbers that neither 3 nor 4 may overwrite
            os.dup2(ask, 100), os.dup2(answer, 101)
            os.dup2(100, 3), os.dup2(101, 4)
            os.closerange(5, 200)
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

        self.process = subprocess.Popen([self.name], env=environment, preexec_fn=wire,
                                        close_fds=False, stdin=subprocess.DEVNULL)
        os.close(ask), os.close(answer)
        self.read = b""

    def answer(self, seconds=None):
        """The next line, or None after so long."""
        while b"\n" not in self.read:
            ready, _, _ = select.select([self.answers], [], [], seconds)
            if not ready:
                return None
            piece = os.read(self.answers, 4096)
            if not piece:
                raise RuntimeError(f"{self.name} does not start")
            self.read += piece
        line, self.read = self.read.split(b"\n", 1)
        return [int(n) for n in line.split()]

    def run(self, folder, log, argument="", steps=None):
        """To the end, or until one step more than `steps` are printed."""
        if self.process is None:
            self.start()
        path = os.path.join(folder, log)
        begin = time.time()
        os.write(self.requests, f"{folder}\t{log}\t{argument}\n".encode())
        (pid,) = self.answer()
        watch = Watch(pid, path, steps)
        while (ended := self.answer(0.05)) is None:
            watch.look()
        status, peak = ended
        stopped = watch.stopped or ("memory" if peak > MEMORY else "")
        with open(path, errors="replace") as file:
            output = file.read()
        return Ended(os.waitstatus_to_exitcode(status), output, time.time() - begin, stopped)

    def end(self):
        if self.process:
            os.close(self.requests)
            self.process.wait()
            os.close(self.answers)
            self.process = None


class Watch:
    """Ends a process that is silent, too large or has done enough."""

    def __init__(self, pid, log, steps):
        self.pid, self.log, self.steps = pid, log, steps
        self.size, self.word, self.spoke = 0, 0.0, time.time()
        self.stopped, self.asked = "", False

    def look(self):
        computed, memory = self.used()
        size = os.path.getsize(self.log) if os.path.exists(self.log) else 0
        if size != self.size:
            self.size, self.word, self.spoke = size, computed, time.time()
            self.enough()
        if memory > MEMORY:
            self.kill("memory")
        elif computed - self.word > SILENCE or time.time() - self.spoke > BLOCKED + \
                3 * (computed - self.word):
            self.kill("hang")
        elif computed > LONGEST:
            self.kill("long")

    def used(self):
        """Seconds of computing and kB of memory."""
        try:
            with open(f"/proc/{self.pid}/stat") as file:
                fields = file.read().rsplit(")", 1)[1].split()
        except (FileNotFoundError, ProcessLookupError):
            return 0.0, 0
        seconds = (int(fields[11]) + int(fields[12])) / TICKS
        return seconds, int(fields[21]) * resource.getpagesize() // 1024

    def enough(self):
        """A Ctrl-C after the steps that are compared."""
        if self.steps is None or self.asked:
            return
        with open(self.log, "rb") as file:
            if len(STEP.findall(file.read())) > self.steps:
                self.asked = True
                os.kill(self.pid, signal.SIGINT)

    def kill(self, why):
        self.stopped = self.stopped or why
        os.kill(self.pid, signal.SIGKILL)
