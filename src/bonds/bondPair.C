/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondPair.H"

Foam::fsbi::bondPair::bondPair
(
    const word& name, const dictionary& dict, const scalar kT
)
:
    name(name),
    roughness(0),
    faces(false),
    faceCorrection("none")
{
    const checkedDictionary entries(dict);
    kinds = entries.get<wordList>("kinds");
    if (kinds.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'kinds' must be two kinds of molecules, (receptor ligand)"
            << exit(FatalIOError);
    }
    law = bondLaw::New(entries, kT);
    if (entries.found("roughness"))
    {
        roughness = entries.positive("roughness");
    }
    faces = entries.choice("sites", {"molecules", "faces"}, "molecules")
     == "faces";
    faceCorrection = entries.choice
    (
        "faceCorrection", {"none", "global", "conserving"}, "none"
    );
    entries.finish();
    rate.reset(new contactRate(law(), roughness));
}
