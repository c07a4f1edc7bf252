# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes pytest print what validation/Alltest collects: a line "ok - ..." or
"NOT OK - ..." for each test, and "N passed, N failed" at the end. Used by the
function pytests of caseChecks:

    python3 -m pytest -p check_lines -qq -o console_output_style=classic

A line has the test's name as words, and its parameters.
"""

import pytest


def named(nodeid):
    """test_x.py::test_no_gap[1e-3] becomes: no gap, 1e-3"""
    test, _, parameters = nodeid.rpartition("::")[2].partition("[")
    words = test.removeprefix("test_").replace("_", " ")
    return f"{words}, {parameters[:-1]}" if parameters else words


def reason(report):
    """The exception, in one line; all of it stands further down."""
    lines = [line[1:].strip() for line in report.longreprtext.splitlines() if line[:1] == "E"]
    return " ".join(lines[:3]) or report.longreprtext.strip().splitlines()[-1]


class CheckLines:
    def __init__(self, printer):
        self.printer = printer
        self.counts = {"ok": 0, "NOT OK": 0}

    def say(self, status, text):
        self.counts[status] += 1
        self.printer.write_line(f"{status} - {text}")

    def pytest_collectreport(self, report):
        if report.failed:
            self.say("NOT OK", f"{report.nodeid} can be read: {reason(report)}")

    def pytest_runtest_logreport(self, report):
        name = named(report.nodeid)
        if report.failed:
            where = "" if report.when == "call" else f" ({report.when})"
            self.say("NOT OK", f"{name}{where}: {reason(report)}")
        elif report.skipped:
            self.say("ok", f"{name}: skipped, {report.longrepr[2].removeprefix('Skipped: ')}")
        elif report.when == "call":
            self.say("ok", name)

    def pytest_report_teststatus(self, report):
        return report.outcome, "", ""           # no dots between the lines

    @pytest.hookimpl(trylast=True)
    def pytest_unconfigure(self):
        print(f"{self.counts['ok']} passed, {self.counts['NOT OK']} failed")


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    printer = config.pluginmanager.getplugin("terminalreporter")
    config.pluginmanager.register(CheckLines(printer))
