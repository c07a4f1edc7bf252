/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coilSet.H"

Foam::fsbi::coilSet::coilSet
(
    const dictionary& dict, const point& place, const units& u
)
{
    tensor sum(Zero);
    for (const entry& e : dict)
    {
        if (!e.isDict() || e.dict().found("current"))
        {
            FatalIOErrorInFunction(dict)
                << "A coil of the controller is name { axis ...; radius ...; }"
                << " without a current; '" << e.keyword() << "' is not"
                << exit(FatalIOError);
        }
        dictionary entries(e.dict());
        entries.set("type", word("coil"));
        entries.set("current", scalar(0));
        coils_.append(magneticField::New(entries, u));
        names_.append(e.keyword());
        perField_.append(refCast<const coil>(coils_.last()).unitB(place));
        sum += perField_.last()*perField_.last();
    }
    // of a set that makes all directions alike it is 1
    if (!(27*det(sum) > 1e-6*pow3(tr(sum))))
    {
        FatalIOErrorInFunction(dict)
            << "The coils cannot make a field of every direction at " << place
            << ": three are needed whose axes do not lie in a plane"
            << exit(FatalIOError);
    }
    perField_ = vectorField(inv(sum) & perField_);
}


Foam::vector Foam::fsbi::coilSet::B
(
    const point& x, const scalarField& currents
) const
{
    vector result(Zero);
    forAll(coils_, i)
    {
        result += currents[i]*refCast<const coil>(coils_[i]).unitB(x);
    }
    return result;
}


Foam::tensor Foam::fsbi::coilSet::gradient
(
    const point& x, const scalarField& currents
) const
{
    tensor result(Zero);
    forAll(coils_, i)
    {
        result += currents[i]*refCast<const coil>(coils_[i]).unitGradient(x);
    }
    return result;
}
