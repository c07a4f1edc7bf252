/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "effectContext.H"

void Foam::fsbi::reportUnseen
(
    const string& what, const UList<unseenPatch>& patches
)
{
    if (patches.size())
    {
        Info<< what.c_str() << " these patches:" << nl;
        for (const unseenPatch& patch : patches)
        {
            Info<< "    " << patch.name << ": " << patch.why.c_str() << nl;
        }
        Info<< endl;
    }
}


Foam::point Foam::fsbi::effectContext::nearestImage
(
    const point& y, const point& x
) const
{
    point nearest(y);
    for (const vector& way : images)
    {
        if (magSqr(y + way - x) < magSqr(nearest - x))
        {
            nearest = y + way;
        }
    }
    return nearest;
}


Foam::string Foam::fsbi::effectContext::unseenReason(const word& name) const
{
    for (const unseenPatch& patch : unseen)
    {
        if (patch.name == name)
        {
            return " (a patch, but " + patch.why + ")";
        }
    }
    return "";
}


Foam::label Foam::fsbi::effectContext::findBody(const word& name) const
{
    forAll(bodies, b)
    {
        if (bodies[b].name() == name)
        {
            return b;
        }
    }
    return -1;
}


Foam::label Foam::fsbi::effectContext::findWall(const word& name) const
{
    forAll(walls, w)
    {
        if (walls[w].name == name)
        {
            return w;
        }
    }
    return -1;
}


Foam::wordList Foam::fsbi::effectContext::names() const
{
    wordList all;
    forAll(bodies, b)
    {
        all.append(bodies[b].name());
    }
    for (const domainWall& wall : walls)
    {
        all.append(wall.name);
    }
    return all;
}


Foam::label Foam::fsbi::effectContext::bodyIndex
(
    const word& name, const dictionary& where
) const
{
    const label b = findBody(name);
    if (b < 0)
    {
        wordList valid;
        forAll(bodies, i)
        {
            valid.append(bodies[i].name());
        }
        FatalIOErrorInFunction(where)
            << "There is no body '" << name << "'; the bodies are "
            << flatOutput(valid) << exit(FatalIOError);
    }
    return b;
}
