# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Break the code in one place after another and see which test notices.

What is known of a mutant stays in platforms/mutants/known.json, as long as it, the
file that it breaks and the folders of its tests are the same; results.csv and
README.md hold what is known at the end.
"""

import argparse
import hashlib
import json
import os
import re
import sys
import time

import broken_tree
import mutant
from fsbi.results import Results

ROOT = os.environ["FSBI_DIR"]
SCRATCH = os.path.join(ROOT, "platforms", "mutants")
KNOWN = os.path.join(SCRATCH, "known.json")

# What a test depends on besides data
SOURCES = ".C", ".H", ".py", "Allrun", "files", "options"


def fingerprint(m):
    """Of a mutant, the file it is in and its tests."""
    places = tuple([m.file] + [
        f"{kind}/{test}/" for test in m.tests for kind in ("applications/test", "validation")])
    digest = hashlib.sha1(m.text.encode())
    for name in broken_tree.sources(ROOT):
        if name.startswith(places) and name.endswith(SOURCES):
            with open(os.path.join(ROOT, name), "rb") as file:
                digest.update(name.encode() + file.read())
    return digest.hexdigest()


def load():
    try:
        with open(KNOWN) as file:
            return json.load(file)
    except FileNotFoundError:
        return {"mutants": {}, "whole": {}}


def save(known):
    with open(KNOWN + ".part", "w") as file:
        json.dump(known, file, indent=1)
    os.replace(KNOWN + ".part", KNOWN)


def entry(known, m):
    """What is known of a mutant as it is."""
    found = known["mutants"].get(m.name)
    return found if found and found["of"] == fingerprint(m) else None


def failures(output):
    """What the checks that failed are called."""
    return re.findall(r"^NOT OK - (.*)$", output, re.M)


def first(mutant, tree, longest):
    """(test, check) that notices first, and the seconds of it all."""
    start = time.time()
    with tree.broken(mutant):
        built = time.time()
        for test in mutant.tests:
            left = longest - (time.time() - built)
            output = tree.test([test], left) if left > 0 else None
            if output is None:
                print(f"    {mutant.name}: more than {longest} s, up to {test}")
                break
            if not re.search(r"^[0-9]+ passed, [0-9]+ failed$", output, re.M):
                raise RuntimeError(f"{mutant.name}: {test} did not come to its end:\n{output}")
            if found := failures(output):
                return found[0].split(": ", 1), time.time() - start
    return None, time.time() - start


def sound(tests, tree, passed):
    """All tests must pass on the code as it is; those that have are listed."""
    for test in tests:
        if test not in passed:
            print(f"    {test}, without a mutant", flush=True)
            output = tree.test([test])
            if failures(output) or not re.search("^[1-9][0-9]* passed, 0 failed$", output, re.M):
                sys.exit(f"test {test} fails without a mutant, too:\n{output[-2000:]}")
            passed.append(test)


def judge(mutants, tree, known, longest, keep):
    """Every mutant, and what noticed it."""
    passed = []
    for m in mutants:
        if (found := entry(known, m)) and found["caught"]:
            continue            # others may have lacked the time
        sound(m.tests[:1], tree, passed)
        caught, seconds = first(m, tree, longest)
        if caught:
            sound([t for t in m.tests if t == caught[0]], tree, passed)
        known["mutants"][m.name] = {"caught": caught, "seconds": seconds, "of": fingerprint(m)}
        print(f"    {m.name}: " + (": ".join(caught) if caught else "NOBODY NOTICES")
              + f" ({seconds:.0f} s)", flush=True)
        if keep:
            save(known)


class Progress:
    """Follows the output of all tests: how many checks of each have failed."""

    def __init__(self, name, done, keep):
        self.name, self.done, self.keep = name, done, keep
        self.test = None
        self.failed = {}

    def __call__(self, line):
        if start := re.match(r"== (\S+) \((\S+)\)", line):
            self.test = " ".join(start.groups())
            self.failed[self.test] = 0
        elif line.startswith("NOT OK - "):
            self.failed[self.test] += 1
        elif re.match(r"   [0-9.]+ s$", line):
            self.done[self.test] = self.failed[self.test]
            print(f"    {self.name}: {self.test}: {self.done[self.test]} checks fail", flush=True)
            self.keep()


def whole(m, tree, known):
    """All tests on a mutant; goes on where it was stopped."""
    of = fingerprint(m)
    if known["whole"].get(m.name, {}).get("of") != of:
        known["whole"][m.name] = {"of": of, "done": {}}
    done = known["whole"][m.name]["done"]
    left = []
    for folder in tree.test(["-list"]).split():
        name = os.path.basename(folder)
        kinds = ["validation"] if folder.startswith("validation") else [
            kind for kind, part in (("program", "Make/files"), ("case", "Allrun"))
            if os.path.exists(os.path.join(tree.path, folder, part))]
        if any(f"{name} {kind}" not in done for kind in kinds):
            left.append(name)
    if left:
        with tree.broken(m):
            tree.test(left, tell=Progress(m.name, done, lambda: save(known)))


def add(results, known, mutants):
    for m in mutants:
        if found := entry(known, m):
            # bound: a mutant is noticed or not
            results.add(m.name, 1 if found["caught"] else 0, 1, 0, seconds=found["seconds"])
    for name, found in sorted(known["whole"].items()):
        # bound: at least the test that is meant to notice
        noticed = sum(map(bool, found["done"].values()))
        results.at_least(f"{name}_tests_that_notice", noticed, 1)


def table(known, mutants):
    """For README.md."""
    yield "| broken | in | noticed by |"
    yield "|---|---|---|"
    for m in mutants:
        if found := entry(known, m):
            caught = found["caught"]
            text = "{}: {}".format(*caught) if caught else "**nobody**"
            text = text.split(": value")[0].replace("|", "\\|")
            yield f"| [{m.what}](changes/{m.name}) | {m.file} | {text[:110]} |"
    if left := [m.name for m in mutants if not entry(known, m)]:
        yield ""
        yield f"Not run yet: {', '.join(left)}."
    for name, found in sorted(known["whole"].items()):
        done = found["done"]
        noticed = ", ".join(sorted(test.split()[0] for test in done if done[test]))
        yield ""
        yield f"{len(done)} tests on `{name}`: it is noticed by {noticed or 'nobody'}."


def write_table(known, mutants):
    with open("README.md") as file:
        text = file.read()
    marks = "<!-- mutants -->\n", "<!-- end -->"
    head, rest = text.split(marks[0])
    with open("README.md", "w") as file:
        file.write(head + marks[0] + "\n".join(table(known, mutants)) + "\n" + marks[1]
                   + rest.split(marks[1])[1])


def arguments():
    parser = argparse.ArgumentParser(prog="Allrun", description=__doc__.split("\n")[0])
    parser.add_argument("-quick", action="store_true", help="those marked so, always anew")
    parser.add_argument("-only", nargs="+", metavar="NAME", help="these")
    parser.add_argument("-whole", nargs="+", metavar="NAME", default=[],
                        help="all tests on each of these")
    parser.add_argument("-longest", type=float, default=120, metavar="SECONDS",
                        help="that the tests of a mutant may take (default: 120); a machine "
                             "with other things to do takes longer")
    return parser.parse_args()


def main():
    options = arguments()
    every = mutant.read("changes")
    for m in every.values():
        m.applied(ROOT)         # stops where one is out of date
    for name in (options.only or []) + options.whole:
        if name not in every:
            sys.exit(f"there is no mutant {name}; there are {', '.join(every)}")
    os.makedirs(SCRATCH, exist_ok=True)
    form = "quick" if options.quick else "whole" if options.whole else "each"
    tree = broken_tree.BrokenTree(ROOT, os.path.join(SCRATCH, form))
    known = load()
    if options.quick:
        known = {"mutants": {}, "whole": {}}
    chosen = [every[name] for name in options.only or every]
    if options.whole:
        for name in options.whole:
            whole(every[name], tree, known)
    else:
        judge([m for m in chosen if m.quick or not options.quick], tree, known,
              600 if options.quick else options.longest, keep=not options.quick)
    results = Results("M1")
    add(results, known, every.values())
    results.write()
    if not options.quick:
        write_table(known, every.values())


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("stopped; the same command goes on")
