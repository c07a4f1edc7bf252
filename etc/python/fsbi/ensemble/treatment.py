# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A drug that is given at some times, and the part of the receptors it blocks when cells
meet.

    C = dose sum_i c(encounter - given_i),      blocked = C/(C + K_D)

with the concentration c in the plasma after a unit dose, and the dissociation constant
K_D: kinetics are linear, so that doses add up, and receptors in equilibrium with the
plasma. c is a table, between its times linear, or that of one compartment,

    intravenous     exp(-k t)/V
    oral            F a (exp(-k t) - exp(-a t))/(V (a - k))

with k = ln 2/half-life, a = ln 2/absorption half-life, F the part that arrives. An
encounter takes milliseconds, so that C is the same all through a run.

Reference
    Gibaldi, M. & Perrier, D. (1982). Pharmacokinetics, 2nd ed., Marcel Dekker: (1.9),
    (1.94).
"""

import math

import numpy as np

from fsbi.studies import Refused
from fsbi.studies.dictionary import shown

from .patients import Patients, column, read_table
from .sampling import Varied, pairs

WORDS = ("doses", "KD", "blocks", "plasma", "intravenous", "oral")
KINETICS = ("plasma", "intravenous", "oral")
COMPARTMENT = {"intravenous": ("volume", "halfLife"),
               "oral": ("volume", "halfLife", "absorptionHalfLife", "bioavailability")}
PROTOCOL_WORDS = ("given", "encounter")


class Label(Varied):
    """Of a run; what it means for the case, Derived says."""

    logarithmic = False

    def __init__(self, name, texts, given):
        super().__init__(name, [])
        self.texts, self.given = texts, given

    def listed(self):
        return self.texts

    def key(self, value):
        return [[self.name, value]]

    def apply(self, entries, value):
        pass


class Amount:
    """A number above zero, or one of every patient: the name of a column."""

    def __init__(self, given, word, patients, default=None):
        text = shown(given.get(word, default))
        try:
            self.number, self.of = given.above(word, 0, default), None
        except Refused:
            if patients is None or _is_number(text):
                raise
            self.number, self.of = None, patients.numbers(text, given.refuse, above=0)

    def __call__(self, patient):
        return self.of[patient] if self.of else self.number


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


class Plasma:
    """Concentration after a unit dose, from a table with `time` and `concentration`."""

    def __init__(self, drug, path):
        self.file = shown(drug.get("plasma"))
        columns, rows = read_table(path(self.file), self.file, drug.refuse)
        for name in ("time", "concentration"):
            if name not in columns:
                drug.refuse(f"{self.file} has no column '{name}' but {', '.join(columns)}")
        self.times, self.values = (column(rows, name, self.file, drug.refuse)
                                   for name in ("time", "concentration"))
        if any(b <= a for a, b in zip(self.times, self.times[1:])):
            drug.refuse(f"{self.file}: times are to grow from line to line")

    def check(self, time, refuse):
        if not self.times[0] <= time <= self.times[-1]:
            refuse(f"the encounter is {time:g} after a dose, but {self.file} has the "
                   f"concentration from {self.times[0]:g} to {self.times[-1]:g}")

    def __call__(self, _, time):
        return float(np.interp(time, self.times, self.values))


class Compartment:
    """The same of one compartment; its constants may be those of a patient."""

    def __init__(self, drug, kind, patients):
        given = drug.section(kind)
        given.only(*COMPARTMENT[kind])
        self.kind = kind
        self.amounts = {word: Amount(given, word, patients,
                                     "1" if word == "bioavailability" else None)
                        for word in COMPARTMENT[kind]}

    def check(self, *_):
        """All times will do."""

    def __call__(self, patient, time):
        of = {word: amount(patient) for word, amount in self.amounts.items()}
        leaving = math.log(2) / of["halfLife"]
        if self.kind == "intravenous":
            return math.exp(-leaving * time) / of["volume"]
        entering = math.log(2) / of["absorptionHalfLife"]
        # (1 - exp(-x))/x, x the difference: also where both are the same
        x = (entering - leaving) * time
        part = -math.expm1(-x) / x if x else 1.0
        return (of["bioavailability"] * entering * time * math.exp(-leaving * time) * part
                / of["volume"])


class Treatment:
    """What `patients`, `drug` and `protocols` say: the parameters patient, protocol and
    dose, and those derived from them, concentration and blocked."""

    def __init__(self, top, path):
        self.patients = Patients(top.section("patients"), path) if "patients" in top else None
        self.parameters, self.derived, self.kinetics = [], [], None
        if self.patients:
            self.parameters.append(self.patients)
        if ("drug" in top) != ("protocols" in top):
            top.refuse("'drug' and 'protocols' belong together")
        if "drug" in top:
            self._read(top, path)

    def _read(self, top, path):
        drug = self.drug = top.section("drug")
        drug.only(*WORDS)
        kind = drug.one(*KINETICS)
        self.kinetics = (Plasma(drug, path) if kind == "plasma"
                         else Compartment(drug, kind, self.patients))
        self.dissociation = Amount(drug, "KD", self.patients)
        doses = [shown(d) for d in drug.list("doses")]
        if any(not _is_number(d) or not 0 <= float(d) < math.inf for d in doses):
            drug.refuse(f"doses are numbers, not below zero: ({' '.join(doses)})")
        self.protocols = {name: self._protocol(given)
                          for name, given in top.sections("protocols").items()}
        self.parameters += [Label("protocol", list(self.protocols), top.section("protocols")),
                            Label("dose", doses, drug)]
        blocked = Varied("blocked", pairs(drug, "blocks"))
        blocked.given = drug
        self.derived = [Label("concentration", [], drug), blocked]
        for patient in self.patients.texts if self.patients else [None]:
            for name in self.protocols:
                if not self.unit(patient, name) > 0:
                    top.refuse(f"protocols, {name}: no drug is in the plasma at the encounter"
                               + (f" of {patient}" if patient else ""))

    def _protocol(self, given):
        """Times since each dose."""
        given.only(*PROTOCOL_WORDS)
        encounter = given.number("encounter")
        times = [encounter - t for t in given.numbers("given")]
        for since in times:
            if since < 0:
                given.refuse(f"a dose is given {-since:g} after the encounter")
            self.kinetics.check(since, given.refuse)
        return times

    def tables(self):
        """Files of the case."""
        found = [self.patients.file] if self.patients else []
        return found + ([self.kinetics.file] if hasattr(self.kinetics, "file") else [])

    def unit(self, patient, protocol):
        """Concentration at the encounter if a dose is 1."""
        return sum(self.kinetics(patient, since) for since in self.protocols[protocol])

    def complete(self, settings):
        """With what follows from them, in the digits that foamDictionary keeps."""
        if not self.derived:
            return settings
        patient = settings.get("patient")
        concentration = float(settings["dose"]) * self.unit(patient, settings["protocol"])
        blocked = concentration / (concentration + self.dissociation(patient))
        return {**settings, "concentration": f"{concentration:.6g}", "blocked": f"{blocked:.6g}"}

    def free(self, settings, dose):
        """Part of the receptors that is free."""
        patient = settings.get("patient")
        binding = self.dissociation(patient)
        return binding / (binding + dose * self.unit(patient, settings["protocol"]))

    def dose(self, settings, free):
        """The other way round."""
        patient = settings.get("patient")
        return (self.dissociation(patient) * (1 / free - 1)
                / self.unit(patient, settings["protocol"]))
