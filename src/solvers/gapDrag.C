/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "gapDrag.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- A domain is long if its diagonal is so many hydraulic radii. A cube with given
//  velocity all around has 5.2, a round tube of twice its diameter in length 5.8
static const scalar longDomain = 7;

//- Walls face each other if the cosine between their normals is below
static const scalar facing = -0.7;

//- Sums of the areas around the vertices of walls with given velocity
static vectorField wallNormals(const stokesOperator& stokes)
{
    const fvMesh& mesh = stokes.stencil().mesh();
    vectorField normal(mesh.nPoints(), Zero);
    forAll(stokes.velocityGiven(), i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        if (stokes.velocityGiven()[i] && !mesh.boundaryMesh()[patchi].coupled())
        {
            for (const label v : mesh.faces()[facei])
            {
                normal[v] += mesh.faceAreas()[facei];
            }
        }
    }
    syncTools::syncPointList(mesh, normal, plusEqOp<vector>(), vector::zero);
    return normal/(mag(normal) + VSMALL);
}


//- Mean width between corners that face each other; zero: it is in no gap
static scalar widthOf
(
    const labelUList& corners, const pointField& x, const vectorField& normal
)
{
    scalar sum = 0;
    label n = 0;
    for (const label a : corners)
    {
        if (normal[a] == vector::zero)
        {
            return 0;
        }
        for (const label b : corners)
        {
            if (a < b && (normal[a] & normal[b]) < facing)
            {
                const vector across(normalised(normal[a] - normal[b]));
                sum += mag(across & (x[a] - x[b]));
                ++n;
            }
        }
    }
    return n ? sum/n : 0;
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalarField Foam::fsbi::gapDrag(const stokesOperator& stokes)
{
    const fvMesh& mesh = stokes.stencil().mesh();
    const vectorField normal(wallNormals(stokes));
    scalarField drag(mesh.nCells(), Zero);
    forAll(drag, celli)
    {
        const scalar d =
            widthOf(mesh.cellPoints()[celli], mesh.points(), normal);
        drag[celli] = d > 0 ? 12*stokes.viscosity(celli)/sqr(d) : 0;
    }
    return drag;
}


Foam::scalar Foam::fsbi::channelDrag(const stokesOperator& stokes)
{
    const fvMesh& mesh = stokes.stencil().mesh();
    scalar area = 0;
    forAll(stokes.velocityGiven(), i)
    {
        const label facei = mesh.nInternalFaces() + i;
        const label patchi = mesh.boundaryMesh().whichPatch(facei);
        if (stokes.velocityGiven()[i] && !mesh.boundaryMesh()[patchi].coupled())
        {
            area += mag(mesh.faceAreas()[facei]);
        }
    }
    reduce(area, sumOp<scalar>());
    const scalar radius = 2*gSum(mesh.cellVolumes())/max(area, VSMALL);
    return
        mag(mesh.bounds().span()) > longDomain*radius
      ? 8*stokes.mu()/sqr(radius)
      : 0;
}
