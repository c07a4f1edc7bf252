/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "parts.H"
#include "oscillator.H"
#include "IFstream.H"
#include "OSspecific.H"

using namespace Foam;
using namespace Foam::fsbi;

void Foam::fsbi::checkWords(checks& c)
{
    const auto refused = [&]
    (
        const std::string& entry, const std::string& text
    )
    {
        c.checkFatal
        (
            "refused: " + (entry.empty() ? "nothing" : entry),
            [&]{ makeScheme(entry); }, text
        );
    };
    refused("Euler", "(Fornberg Newmark generalisedAlpha steadyState)");
    refused("", "valid schemes");
    refused("2", "valid schemes");
    refused("Fornberg", "Fornberg <order 1, 2, 3 or 4>");
    refused("Fornberg 5", "order 5");
    refused("Fornberg 1.5", "Fornberg <order");
    refused("Fornberg two", "Fornberg <order");
    refused("Newmark 0.25", "Newmark [<beta> <gamma>]");
    refused("Newmark 0 0.5", "beta above 0");
    refused("Newmark 0.25 0.4", "unstable");
    refused("generalisedAlpha 1.2", "rhoInfinity");
    refused("generalisedAlpha 0.8 1", "generalisedAlpha [<rhoInfinity>]");
    refused("steadyState 1", "steadyState");

    autoPtr<motionScheme> s(makeScheme("Fornberg 2"));
    dictionary state;
    s->save(state);
    c.checkFatal
    (
        "refused: restart with another scheme",
        [&]{ makeScheme("Newmark")->restore(state); }, "cannot continue"
    );
    c.checkFatal
    (
        "refused: restart with another order",
        [&]{ makeScheme("Fornberg 3")->restore(state); }, "cannot continue"
    );

    const fileName annotated
    (
        getEnv("FSBI_DIR")/"etc/dictionaries/fvSchemes.solid"
    );
    const dictionary schemes{IFstream(annotated)()};
    c.check
    (
        "etc/dictionaries/fvSchemes.solid is read",
        motionScheme::New(schemes.subDict("d2dt2Schemes").lookup("default"))
            ->type() == "Fornberg"
    );
}
