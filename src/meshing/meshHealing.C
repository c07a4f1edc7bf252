/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshHealing.H"
#include "meshQuality.H"
#include "meshRepair.H"

namespace Foam
{
namespace fsbi
{

//- Degrees below the limit at which repair aims, and that it must reach
static const scalar aim = 15, spare = 5;

//- Degrees beyond which faces are swept: what holds the mean
static const scalar sweepFrom = 35;

//- Sweeps, until the mean is what it was
static const label mostSweeps = 3;

//- Degrees below which repair is no longer local
static const scalar lowest = 50;

//- Degrees by which the mean non-orthogonality may be above the last whole mesh's
static const scalar drift = 0.3;

//- Factor between lengths of edges and those wanted
static const scalar sizeFactor = 1.5;

//- Edges that gmsh makes, over those that it is asked for
static const scalar gmshEdge = 1.2;

//- About as many points are looked at
static const label sample = 2000;

//- Part of the points that may have other sizes
static const scalar fewPoints = 0.02;

} // End namespace fsbi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::scalar Foam::fsbi::missized
(
    const meshLists& mesh, const sizeFunction& size
)
{
    const label every = max(mesh.points.size()/sample, 1);
    const auto sampled = [every](const label p) { return p % every == 0; };
    scalarField length(mesh.points.size(), Zero);
    labelList n(mesh.points.size(), Zero);
    for (const face& f : mesh.faces)
    {
        forAll(f, i)
        {
            const label a = f[i], b = f.nextLabel(i);
            if (sampled(a) || sampled(b))
            {
                const scalar d = mag(mesh.points[a] - mesh.points[b]);
                length[a] += d;
                length[b] += d;
                ++n[a];
                ++n[b];
            }
        }
    }
    label wrong = 0, all = 0;
    forAll(n, p)
    {
        if (sampled(p) && n[p])
        {
            const scalar ratio =
                length[p]/(n[p]*gmshEdge*size(mesh.points[p]));
            wrong += max(ratio, 1/ratio) > sizeFactor;
            ++all;
        }
    }
    return scalar(wrong)/max(all, 1);
}


Foam::fsbi::freshMesh::freshMesh
(
    const meshLists& mesh, const sizeFunction& size
)
{
    const meshQuality quality(mesh);
    largest = quality.maxNonOrthogonality;
    mean = quality.meanNonOrthogonality;
    missized = fsbi::missized(mesh, size);
}


Foam::fsbi::freshMesh::freshMesh(const dictionary& saved)
:
    largest(saved.getOrDefault<scalar>("largest", 0)),
    mean(saved.getOrDefault<scalar>("mean", 0)),
    missized(saved.getOrDefault<scalar>("missized", 0))
{}


Foam::dictionary Foam::fsbi::freshMesh::dict() const
{
    dictionary saved;
    saved.set("largest", largest);
    saved.set("mean", mean);
    saved.set("missized", missized);
    return saved;
}


Foam::Ostream& Foam::fsbi::operator<<(Ostream& os, const freshMesh& m)
{
    return os << m.largest << token::SPACE << m.mean << token::SPACE << m.missized;
}


Foam::Istream& Foam::fsbi::operator>>(Istream& is, freshMesh& m)
{
    return is >> m.largest >> m.mean >> m.missized;
}


Foam::fsbi::outcome Foam::fsbi::heal
(
    meshLists& mesh,
    const remeshControls& limits,
    const freshMesh& fresh,
    const sizeFunction& size,
    const wordList& bodies
)
{
    meshRepair repair(mesh, bodies);
    if (!repair.possible())
    {
        return outcome::failed("not all cells are tetrahedra");
    }
    for (label k = 0; k < mostSweeps; ++k)
    {
        repair.sweep(sweepFrom);
        if (repair.meanNonOrthogonality() < fresh.mean + drift/2)
        {
            break;
        }
    }
    repair.run(max(limits.maxNonOrthogonality - aim, lowest));
    repair.putInto(mesh);

    remeshControls wanted(limits);
    wanted.maxNonOrthogonality -= spare;
    const meshQuality quality(mesh);
    const string reason(quality.failureReason(wanted));
    if (reason.size())
    {
        return outcome::failed(reason);
    }
    if (quality.meanNonOrthogonality > fresh.mean + drift)
    {
        return outcome::failed
        (
            "mean non-orthogonality " + name(quality.meanNonOrthogonality)
          + " degrees, of the last whole mesh " + name(fresh.mean)
        );
    }
    const scalar wrong = missized(mesh, size);
    if (wrong > max(fewPoints, 2*fresh.missized))
    {
        return outcome::failed
        (
            "edges at " + name(100*wrong) + " % of the points are not as long"
            " as wanted"
        );
    }
    return outcome();
}
