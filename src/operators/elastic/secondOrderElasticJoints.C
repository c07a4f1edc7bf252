/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// Where two parts of the body meet

#include "secondOrderElastic.H"
#include "asVectors.H"

void Foam::fsbi::secondOrderElastic::addJoints
(
    const tensorField& stress, const vectorField& held, scalar* r
) const
{
    const partJoints& joints = stencil_.joints();
    vector* row = asVectors(r);
    vectorField force(joints.size(), Zero);
    forAll(held, i)
    {
        const partJoints::half& h = joints.halves()[i];
        const vector T
        (
            (h.mean(stress) & h.area)
          + state_.shearModulus()*h.compact*held[i]
        );
        row[h.cell] -= T;
        force[h.joint] += T;
    }
    UList<vector> rows(asVectors(r + firstJointRow()), joints.owned().size());
    joints.sum(force, rows);
}


void Foam::fsbi::secondOrderElastic::addJoints(scalar* r)
{
    const List<partJoints::half>& halves = stencil_.joints().halves();
    if (!stencil_.vertices().several())
    {
        return;
    }
    vectorField held(halves.size());
    forAll(halves, i)
    {
        unexplainedHalves_[i] =
            unexplainedHalf(i, values_, state_.gradient());
        held[i] =
            (stabilisation + halves[i].mean(stiffening_))
           *unexplainedHalves_[i];
    }
    addJoints(state_.stress(), held, r);
}


void Foam::fsbi::secondOrderElastic::addJointTangents(scalar* dr) const
{
    const List<partJoints::half>& halves = stencil_.joints().halves();
    if (!stencil_.vertices().several())
    {
        return;
    }
    vectorField held(halves.size());
    forAll(halves, i)
    {
        held[i] =
            (stabilisation + halves[i].mean(stiffening_))
           *unexplainedHalf(i, dValues_, dGradient_)
          + halves[i].mean(dStiffening_)*unexplainedHalves_[i];
    }
    addJoints(dStress_, held, dr);
}
