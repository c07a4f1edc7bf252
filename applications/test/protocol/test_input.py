# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What cannot be used is refused in one line that says where and what there is; the
manual's pages are dictionaries that can be used."""

import os
import re
import shutil

import pytest
from binding import PATIENTS, PLASMA, TEXT, call, new

from fsbi.ensemble import patients, smallest, treatment
from fsbi.ensemble.dictionary import Description
from fsbi.studies import Refused
from fsbi.studies.entries import Entries

# what is replaced, by what, what the message has
WRONG = {
    "a patients' column that is none": (
        "{ receptors ", "{ receptor ",
        "patients, entries: constant/patients.csv has no column 'receptor' but receptors, KD"),
    "a table that is not there": ("patients.csv", "people.csv", "no table constant/people.csv"),
    "an entry that is none": ("Dict:receptors", "Dict:receptor", "no entry receptor"),
    "an unknown keyword": ("    KD ", "    Kd ", "drug: unknown keyword 'Kd'; there are doses"),
    "a negative dose": ("(0 10 40)", "(0 -10 40)", "drug: doses are numbers, not below zero"),
    "a dose that is no number": ("(0 10 40)", "(0 ten 40)", "drug: doses are numbers"),
    "a dose twice": ("(0 10 40)", "(0 40 40)", "A once 40 stands there twice"),
    "no doses": ("doses       (0 10 40);", "", "drug: 'doses' is missing"),
    "a K_D of zero": ("KD          0.5", "KD 0", "'KD' is to be above 0"),
    "a K_D that is no column": ("KD          0.5", "KD affinity",
                                "no column 'affinity' but receptors, KD, remark"),
    "a K_D that is no number": ("KD          0.5", "KD remark",
                                "line 2: remark is 'first', not a number"),
    "no kinetics": ('plasma      "constant/plasma.csv";', "", "drug: has none of plasma, intra"),
    "two of them": ("doses ", "oral { volume 1; } doses ", "drug: has several of"),
    "a constant that is missing": (
        'plasma      "constant/plasma.csv"', "oral { volume 4; halfLife 1; }",
        "drug, oral: 'absorptionHalfLife' is missing"),
    "a drug without protocols": ("protocols", "protocol", "unknown keyword 'protocol'"),
    "an encounter after the table": ("encounter 6; }\n    twice", "encounter 9; }\n    twice",
                                     "9 after a dose, but constant/plasma.csv has the"),
    "a dose after the encounter": ("(0 4)", "(0 7)", "given 1 after the encounter"),
    "an encounter without a drug": ("given (0); encounter 6", "given (6); encounter 6",
                                    "once: no drug is in the plasma at the encounter of A"),
    "a drawn sampling": ("seeds           3", "sampling random; samples 3; seeds each",
                         "'patients' belongs to a grid, not to random"),
    "a smallest of a mean": ("quantity bond;", "quantity density;", "'density' is not one of bond"),
    "a smallest of no parameter": ("quantity bond;", "quantity bond; parameter time;",
                                   "parameter 'time' is not one of patient, protocol, dose"),
    "a smallest of words": ("quantity bond;", "quantity bond; parameter patient;",
                            "values of patient are not numbers"),
    "a probability of 40": ("below 0.4", "below 40", "'below' is a probability, below 1"),
    "two sides": ("below 0.4", "below 0.4; above 0.1", "has several of below, above"),
    "a quantity by the name of a column": ("bond        {", "blocked {",
                                           "'blocked' names two columns"),
}
TABLES = {
    "a concentration that is missing": (
        "plasma", "2,0.1", "2,", "plasma.csv, line 3: concentration is missing"),
    "one below zero": ("plasma", "2,0.1", "2,-0.1", "line 3: concentration is to be not below"),
    "a column by another name": ("plasma", "concentration", "c",
                                 "plasma.csv has no column 'concentration' but time, c"),
    "times that fall": ("plasma", "2,0.1", "5,0.1", "times are to grow from line to line"),
    "nothing": ("plasma", PLASMA, "", "plasma.csv is empty"),
    "a header alone": ("plasma", PLASMA, "time,concentration\n", "no line but its header"),
    "a line too short": ("patients", "B,1.5,2,", "B,1.5", "line 3: 2 values, but 4 columns"),
    "a density below zero": ("patients", "B,1.5", "B,-1.5",
                             "line 3: receptors is to be not below zero, not -1.5"),
    "a density that is no number": ("patients", "B,1.5", "B,many", "is 'many', not a number"),
    "a patient twice": ("patients", "B,1.5", "A,1.5", "a name of its own, not 'A'"),
    "no patients": ("patients", "patient,", "person,", "has no column 'patient' but person"),
    "two columns alike": ("patients", "KD,", "receptors,", "has two columns 'receptors'"),
}


def refused(case):
    """What is said of it."""
    with pytest.raises(Refused) as found:
        Description(case).check(Entries(case))
    text = str(found.value)
    assert "\n" not in text
    return text


@pytest.mark.parametrize("old, other, message", WRONG.values(), ids=WRONG.keys())
def test_one_line_says_what_is_wrong(tmp_path, old, other, message):
    assert TEXT.count(old) == 1 or old == "patients.csv"
    assert message in refused(new(tmp_path / "case", TEXT.replace(old, other)))


@pytest.mark.parametrize("table, old, other, message", TABLES.values(), ids=TABLES.keys())
def test_so_of_a_table(tmp_path, table, old, other, message):
    text = dict(patients=PATIENTS, plasma=PLASMA)[table]
    assert text.count(old) == 1
    case = new(tmp_path / "case", **{table: text.replace(old, other)})
    assert message in refused(case)


def test_the_command_says_it_too_and_runs_nothing(tmp_path):
    case = new(tmp_path / "case", TEXT.replace("(0 10 40)", "(0 -10 40)"))
    done = call(case)
    assert done.returncode == 1 and not os.path.exists(f"{case}/ensemble")
    assert done.stderr.strip() == "fsbiEnsemble: system/ensembleDict, drug: doses are numbers, " \
        "not below zero: (0 -10 40)"


def test_help_tells_of_patients_and_doses():
    done = call("-help")
    assert done.returncode == 0 and "patients" in done.stdout and "smallest.csv" in done.stdout


MANUAL = os.path.join(os.environ["FSBI_DIR"], "etc/dictionaries/ensembleDict.protocol")


def test_manual_is_a_dictionary_that_can_be_used(tmp_path):
    case = new(tmp_path / "case", patients="patient,LFA1,ICAM1,KD,weight\nA,1,2,3,4\n")
    shutil.copy(MANUAL, f"{case}/system/ensembleDict")
    about = Description(case)
    assert [p.name for p in about.all_parameters()] == [
        "patient", "protocol", "dose", "concentration", "blocked", "seed"]
    assert about.smallest.probability == 0.2


def test_manual_has_every_keyword():
    with open(MANUAL) as file:
        text = file.read()
    words = (*patients.WORDS, *treatment.WORDS, *treatment.PROTOCOL_WORDS,
             *smallest.Wanted.WORDS, *treatment.COMPARTMENT["oral"])
    assert [w for w in words if not re.search(rf"\b{w}\b", text)] == []
