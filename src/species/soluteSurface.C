/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "soluteSurface.H"

namespace Foam
{
namespace fsbi
{

//- Fatal if an entry is negative
static scalar notNegative
(
    const checkedDictionary& entries, const word& key, const scalar value
)
{
    if (!(value >= 0))
    {
        FatalIOErrorInFunction(entries.dict())
            << "Entry '" << key << "' must not be negative, but is " << value
            << exit(FatalIOError);
    }
    return value;
}

static scalar notNegative(const checkedDictionary& entries, const word& key)
{
    return notNegative(entries, key, entries.get<scalar>(key));
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::soluteSurface::soluteSurface(const dictionary& dict)
:
    name_(dict.dictName())
{
    const checkedDictionary entries(dict);
    type_ = entries.choice
    (
        "type",
        {"inflow", "fixedConcentration", "release", "uptake", "binding"}
    );
    read(entries);
    entries.finish();
}


void Foam::fsbi::soluteSurface::read(const checkedDictionary& entries)
{
    if (type_ == "inflow")
    {
        given_ = notNegative(entries, "concentration");
    }
    else if (type_ == "fixedConcentration")
    {
        given_ = notNegative(entries, "value");
    }
    else if (type_ == "release" && entries.found("store"))
    {
        finite_ = true;
        start_ = notNegative(entries, "store");
        k_ = notNegative(entries, "k");
    }
    else if (type_ == "release")
    {
        given_ = notNegative(entries, "rate");
    }
    else if (type_ == "uptake")
    {
        k_ = notNegative(entries, "k");
    }
    else
    {
        kOn_ = notNegative(entries, "kOn");
        kOff_ = notNegative(entries, "kOff");
        sites_ = entries.positive("sites");
        start_ = notNegative
        (
            entries, "bound", entries.getOrDefault<scalar>("bound", 0)
        );
        if (start_ > sites_)
        {
            FatalIOErrorInFunction(entries.dict())
                << "More is 'bound' at the start, " << start_
                << ", than there are 'sites', " << sites_ << exit(FatalIOError);
        }
    }
}


Foam::labelPair Foam::fsbi::soluteSurface::faces(const polyMesh& mesh) const
{
    const label patchi = mesh.boundaryMesh().findPatchID(name_);
    if (patchi < 0)
    {
        return {0, 0};
    }
    const polyPatch& patch = mesh.boundaryMesh()[patchi];
    return {patch.start() - mesh.nInternalFaces(), patch.size()};
}


void Foam::fsbi::soluteSurface::set
(
    const label first,
    const label size,
    const scalar dt,
    const scalar area,
    const memory& before,
    const UList<scalar>& bound,
    const UList<scalar>& c,
    boundaryLaw& law
) const
{
    boundaryLaw::kind kind = boundaryLaw::exchange;
    scalar a = 0, b = 0;
    if (isInflow())
    {
        kind = boundaryLaw::open;
    }
    else if (type_ == "fixedConcentration")
    {
        kind = boundaryLaw::fixed;
    }
    else if (type_ == "release")
    {
        b =
            finite_
          ? -before.held*std::expm1(-k_*dt)/(max(area, VSMALL)*dt)
          : given_;
    }
    else
    {
        a = k_;
    }
    for (label i = first; i < first + size; ++i)
    {
        if (binds())
        {
            const scalar after = boundAfter(bound[i], dt, c[i]);
            a = kOn_*(sites_ - after)/(1 + dt*(kOff_ + kOn_*c[i]));
            b = a*c[i] - (after - bound[i])/dt;
        }
        law.kinds[i] = kind;
        law.value[i] = given_;
        law.a[i] = a;
        law.b[i] = b;
    }
}


Foam::fsbi::soluteSurface::memory Foam::fsbi::soluteSurface::after
(
    const memory& before,
    const scalar dt,
    const scalar taken,
    const scalar wall
) const
{
    memory m(before);
    m.released -= taken;
    m.rate = -taken/dt;
    m.wall = wall;
    if (finite_)
    {
        m.held += taken;
    }
    return m;
}
