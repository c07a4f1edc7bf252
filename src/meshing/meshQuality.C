/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshQuality.H"
#include "polyMesh.H"
#include "polyMeshTools.H"
#include "unitConversion.H"
#include "StringStream.H"

namespace Foam
{
namespace fsbi
{

static scalar angle(const vector& d, const vector& S)
{
    const scalar c = (d & S)/(mag(d)*mag(S) + VSMALL);
    return radToDeg(Foam::acos(max(min(c, scalar(1)), scalar(-1))));
}


// Centres and volumes from the pyramids over the faces
static void cellGeometry
(
    const meshLists& mesh,
    const vectorField& Sf, const pointField& Cf,
    pointField& C, scalarField& V
)
{
    pointField centre(C.size(), Zero);
    labelList n(C.size(), Zero);
    const auto forSides = [&](auto&& visit)
    {
        forAll(mesh.faces, f)
        {
            visit(f, mesh.owner[f], 1);
            if (f < mesh.neighbour.size())
            {
                visit(f, mesh.neighbour[f], -1);
            }
        }
    };
    forSides([&](const label f, const label c, const label)
    {
        centre[c] += Cf[f];
        ++n[c];
    });
    forAll(centre, c)
    {
        centre[c] /= n[c];
    }
    V = 0;
    C = Zero;
    forSides([&](const label f, const label c, const label sign)
    {
        const scalar pyramid = sign*(Sf[f] & (Cf[f] - centre[c]))/3;
        V[c] += pyramid;
        C[c] += pyramid*(0.75*Cf[f] + 0.25*centre[c]);
    });
    forAll(C, c)
    {
        C[c] = mag(V[c]) > VSMALL ? C[c]/V[c] : centre[c];
    }
}

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::meshQuality::meshQuality(const meshLists& mesh)
:
    maxNonOrthogonality(0),
    meanNonOrthogonality(0),
    maxSkewness(0),
    minVolume(GREAT),
    minVolumeRatio(1),
    nCells(mesh.nCells())
{
    vectorField Sf(mesh.faces.size());
    pointField Cf(mesh.faces.size());
    forAll(Sf, f)
    {
        Sf[f] = mesh.faces[f].areaNormal(mesh.points);
        Cf[f] = mesh.faces[f].centre(mesh.points);
    }
    pointField C(nCells);
    scalarField V(nCells);
    cellGeometry(mesh, Sf, Cf, C, V);
    minVolume = V.size() ? min(V) : 0;

    forAll(mesh.neighbour, f)
    {
        const point& P = C[mesh.owner[f]];
        const vector d(C[mesh.neighbour[f]] - P);
        const scalar a = angle(d, Sf[f]);
        maxNonOrthogonality = max(maxNonOrthogonality, a);
        meanNonOrthogonality += a/mesh.neighbour.size();

        // as checkMesh: distance of the face centre from the line of centres
        const vector Cpf(Cf[f] - P);
        const vector sv(Cpf - (Sf[f] & Cpf)/((Sf[f] & d) + VSMALL)*d);
        const vector dir(sv/(mag(sv) + VSMALL));
        scalar reach = 0.2*mag(d);
        for (const label p : mesh.faces[f])
        {
            reach = max(reach, mag(dir & (mesh.points[p] - Cf[f])));
        }
        maxSkewness = max(maxSkewness, mag(sv)/reach);
    }
}


Foam::fsbi::meshQuality::meshQuality
(
    const polyMesh& mesh, const scalarField& reference
)
:
    minVolume(gMin(mesh.cellVolumes())),
    minVolumeRatio(1),
    nCells(returnReduce(mesh.nCells(), sumOp<label>()))
{
    tmp<scalarField> ortho
    (
        polyMeshTools::faceOrthogonality
        (
            mesh, mesh.faceAreas(), mesh.cellCentres()
        )
    );
    scalarField angles(ortho().size());
    forAll(angles, f)
    {
        angles[f] =
            radToDeg(Foam::acos(max(min(ortho()[f], scalar(1)), scalar(-1))));
    }
    // boundary faces have orthogonality 1: no part in the maximum
    maxNonOrthogonality = gMax(angles);
    meanNonOrthogonality = gAverage(angles);
    maxSkewness = gMax
    (
        polyMeshTools::faceSkewness
        (
            mesh, mesh.points(), mesh.faceCentres(), mesh.faceAreas(),
            mesh.cellCentres()
        )()
    );
    if (notNull(reference))
    {
        minVolumeRatio = gMin(scalarField(mesh.cellVolumes()/reference));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::fsbi::meshQuality::failureReason
(
    const remeshControls& limits, const scalar twist
) const
{
    OStringStream why;
    if (nCells == 0 || !(minVolume > 0))
    {
        why << "smallest cell volume " << minVolume;
    }
    else if (!(maxNonOrthogonality <= limits.maxNonOrthogonality))
    {
        why << "non-orthogonality " << maxNonOrthogonality << " degrees";
    }
    else if (!(maxSkewness <= limits.maxSkewness))
    {
        why << "skewness " << maxSkewness;
    }
    else if (!(minVolumeRatio >= limits.minVolumeRatio))
    {
        why << "a cell has shrunk to " << minVolumeRatio << " of its volume";
    }
    else if (twist > limits.maxTwist)
    {
        why << "a body has turned by " << twist << " rad";
    }
    return why.str();
}
