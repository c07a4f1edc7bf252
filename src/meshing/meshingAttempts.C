/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshingAttempts.H"
#include "meshQuality.H"

Foam::fsbi::meshLists Foam::fsbi::firstGoodMesh
(
    const remeshControls& controls,
    const std::function<meshLists(const meshingAttempt&)>& make,
    const scalar bearable
)
{
    // HXT, which is not repeatable, only where it is asked for: a run continued
    // from a saved state must get the meshes that the first one got
    const int Delaunay = 1, HXT = 10;
    const int first = controls.algorithm == "HXT" ? HXT : Delaunay;
    const int n = controls.optimise;
    const meshingAttempt attempts[] =
    {
        {first, 1, n, 1},
        {Delaunay, 2, n + 1, 1.6},
        {Delaunay, 3, n + 2, 2.5}
    };
    remeshControls loose(controls);
    loose.maxNonOrthogonality = bearable;

    meshLists mesh, best;
    best.failure = "none";
    scalar least = GREAT;
    string failures;
    for (const meshingAttempt& settings : attempts)
    {
        mesh = make(settings);
        if (mesh.valid())
        {
            const meshQuality quality(mesh);
            mesh.failure = quality.failureReason(controls);
            if (mesh.valid())
            {
                return mesh;
            }
            if
            (
                quality.failureReason(loose).empty()
             && quality.maxNonOrthogonality < least
            )
            {
                least = quality.maxNonOrthogonality;
                best = mesh;
                best.failure.clear();
            }
        }
        failures += (failures.empty() ? "" : "; then ") + mesh.failure;
    }
    if (best.valid())
    {
        return best;
    }
    mesh = meshLists();
    mesh.failure = failures;
    return mesh;
}
