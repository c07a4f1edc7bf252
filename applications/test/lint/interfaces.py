# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Classes of libraries with more than 15 public functions whose header does not say
why: a section "Interface" of the manual at its top.

    interfaces.py FOLDER    a line for each; exit 1 if there is one
    interfaces.py FOLDER -list    classes by their number of functions
"""

import re
import sys

from lengths import sources

MOST = 15
COMMENT = re.compile(r"/\*.*?\*/|//[^\n]*", re.S)
TEXT = re.compile(r'"(?:\\.|[^"\\])*"' + r"|'(?:\\.|[^'\\])'")
TYPE = re.compile(r"\b(class|struct)\s+(\w+)[^;{}()]*$")
ACCESS = re.compile(r"\b(public|protected|private)\s*:(?!:)")
MAKERS = ("New", "declareRunTimeSelectionTable")
REASON = re.compile(r"^Interface\n    \S", re.M)


class Scope:
    """What stands between two braces: a class, or anything else."""

    def __init__(self, kind="", name=""):
        self.name = name if kind else ""
        self.public = kind == "struct"
        self.functions = []


def function(statement, class_name):
    """Name of the member function that is declared, if it belongs to the class: neither
    what makes or ends objects nor what a base class has declared."""
    head = statement.split("(", 1)[0]
    if ("(" not in statement or re.search(r"\b(friend|typedef|using)\b|=\s*$", head)
            or re.search(r"\boverride\b", statement)):
        return None
    operator = re.search(r"operator\s*(\S+|\(\))?\s*$", head)
    if operator:
        return operator.group().replace(" ", "")
    name = re.search(r"([~\w]+)\s*$", head)
    if not name or "~" in name.group(1) or name.group(1) in (class_name, *MAKERS):
        return None
    before = head[:name.start()].strip()
    return name.group(1) if before or re.match(r"[a-z]", name.group(1)) else None


def classes(text):
    """(class, names of its public functions); overloads count once."""
    text = TEXT.sub("0", COMMENT.sub("", text))
    text = re.sub(r"^\s*#.*?(?<!\\)$", "", text, flags=re.M | re.S)
    found, scopes, begin, depth = [], [Scope()], 0, 0
    for i, c in enumerate(text):
        if c in "()":
            depth += 1 if c == "(" else -1
        if depth or c not in "{};:":
            continue
        statement = text[begin:i].strip()
        if c == ":":
            access = ACCESS.search(text[begin:i + 1])
            if access and text[i + 1:i + 2] != ":":
                scopes[-1].public = access.group(1) == "public"
                begin = i + 1
            continue
        here = scopes[-1]
        if c != "}" and here.name and here.public:
            name = function(statement, here.name)
            if name and name not in here.functions:
                here.functions.append(name)
        if c == "{":
            kind = TYPE.search(statement)
            scopes.append(Scope(*kind.groups()) if kind else Scope())
            if kind:
                found.append(scopes[-1])
        elif c == "}":
            scopes.pop()
        begin = i + 1
    return [(s.name, s.functions) for s in found]


def main():
    rows = []
    for path in sources(sys.argv[1]):
        if path.endswith(".H"):
            with open(path) as file:
                text = file.read()
            rows += [(len(f), path, name, f, bool(REASON.search(text)))
                     for name, f in classes(text)]
    if "-list" in sys.argv:
        for n, path, name, functions, reason in sorted(rows, reverse=True):
            print(n, name, path, "says why" if reason else "", *functions)
        return False
    wrong = [r for r in rows if r[0] > MOST and not r[4]]
    for n, path, name, _, _ in wrong:
        print(f"{path}: {name} has {n} public functions, more than {MOST}, and no section "
              "'Interface' that says why")
    return bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
