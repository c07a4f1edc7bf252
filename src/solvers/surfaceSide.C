/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include <mpi.h>
#include "surfaceSide.H"
#include "UPstream.H"

void Foam::fsbi::surfaceSide::sum(vectorField& numbered)
{
    if (UPstream::parRun())
    {
        MPI_Allreduce
        (
            MPI_IN_PLACE, numbered.data()->v_, 3*numbered.size(), MPI_DOUBLE,
            MPI_SUM, MPI_COMM_WORLD
        );
    }
}


Foam::vectorField Foam::fsbi::surfaceSide::collectFaces
(
    const vectorField& values
) const
{
    vectorField numbered(nFaces, Zero);
    forAll(faces, i)
    {
        numbered[faceNumbers[i]] = values[faces[i]];
    }
    sum(numbered);
    return numbered;
}


Foam::vectorField Foam::fsbi::surfaceSide::collectPoints
(
    const vectorField& values
) const
{
    vectorField numbered(nPoints, Zero);
    forAll(points, i)
    {
        if (contributes[i])
        {
            numbered[pointNumbers[i]] = values[points[i]];
        }
    }
    sum(numbered);
    return numbered;
}


void Foam::fsbi::surfaceSide::spreadFaces
(
    const vectorField& numbered, vectorField& values
) const
{
    forAll(faces, i)
    {
        values[faces[i]] = numbered[faceNumbers[i]];
    }
}


void Foam::fsbi::surfaceSide::spreadPoints
(
    const vectorField& numbered, vectorField& values
) const
{
    forAll(points, i)
    {
        values[points[i]] = numbered[pointNumbers[i]];
    }
}
