/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "cellGradients.H"
#include "sharedVertices.H"
#include "syncTools.H"

Foam::fsbi::cellGradients::cellGradients(const meshStencil& stencil)
:
    stencil_(stencil)
{}


void Foam::fsbi::cellGradients::give
(
    const boolList& faces, const scalarField& values
)
{
    const fvMesh& mesh = stencil_.mesh();
    scalarField sum(mesh.nPoints(), Zero);
    scalarField count(mesh.nPoints(), Zero);
    forAll(faces, i)
    {
        if (faces[i])
        {
            for (const label v : mesh.faces()[mesh.nInternalFaces() + i])
            {
                sum[v] += values[i];
                count[v] += 1;
            }
        }
    }
    syncTools::syncPointList(mesh, sum, plusEqOp<scalar>(), scalar(0));
    syncTools::syncPointList(mesh, count, plusEqOp<scalar>(), scalar(0));
    DynamicList<label> vertices;
    DynamicList<scalar> means;
    forAll(count, v)
    {
        if (count[v] > 0)
        {
            vertices.append(v);
            means.append(sum[v]/count[v]);
        }
    }
    givenVertices_ = vertices;
    given_ = means;
}


void Foam::fsbi::cellGradients::set
(
    const scalarField& c, const scalar part, vectorField& g
) const
{
    const fvMesh& mesh = stencil_.mesh();
    scalarField atVertex(mesh.nPoints(), Zero);
    forAll(atVertex, v)
    {
        const label end = stencil_.vertexStart()[v + 1];
        for (label k = stencil_.vertexStart()[v]; k < end; ++k)
        {
            atVertex[v] +=
                stencil_.vertexWeight()[k]*c[stencil_.vertexCell()[k]];
        }
    }
    sharedVertices::sum<1>(mesh, atVertex.begin(), stencil_.halo().size());
    forAll(givenVertices_, k)
    {
        atVertex[givenVertices_[k]] = part*given_[k];
    }
    g.setSize(c.size());
    for (label celli = 0; celli < mesh.nCells(); ++celli)
    {
        vector sum(Zero);
        const label end = stencil_.cellStart()[celli + 1];
        for (label k = stencil_.cellStart()[celli]; k < end; ++k)
        {
            sum += atVertex[stencil_.cellVertex()[k]]*stencil_.cellCoeff()[k];
        }
        g[celli] = sum;
    }
    stencil_.halo().fill(reinterpret_cast<scalar*>(g.data()), 3);
}


Foam::scalarField Foam::fsbi::cellGradients::limits
(
    const scalarField& c, const vectorField& g
) const
{
    const fvMesh& mesh = stencil_.mesh();
    const label n = mesh.nCells();
    scalarField least(mesh.nPoints(), GREAT);
    scalarField most(mesh.nPoints(), -GREAT);
    const auto visit = [&](const label celli, const auto& f)
    {
        const label end = stencil_.cellStart()[celli + 1];
        for (label k = stencil_.cellStart()[celli]; k < end; ++k)
        {
            f(stencil_.cellVertex()[k]);
        }
    };
    for (label celli = 0; celli < n; ++celli)
    {
        visit(celli, [&](const label v)
        {
            least[v] = min(least[v], c[celli]);
            most[v] = max(most[v], c[celli]);
        });
    }
    syncTools::syncPointList(mesh, least, minEqOp<scalar>(), GREAT);
    syncTools::syncPointList(mesh, most, maxEqOp<scalar>(), -GREAT);
    forAll(givenVertices_, k)
    {
        const label v = givenVertices_[k];
        least[v] = min(least[v], given_[k]);
        most[v] = max(most[v], given_[k]);
    }
    scalarField psi(c.size(), 1);
    for (label celli = 0; celli < n; ++celli)
    {
        visit(celli, [&](const label v)
        {
            const scalar rise =
                g[celli] & (mesh.points()[v] - mesh.cellCentres()[celli]);
            const scalar room = (rise > 0 ? most[v] : least[v]) - c[celli];
            // a rise that is no more than digits needs no room
            if (mag(rise) > 1e-14*mag(c[celli]))
            {
                psi[celli] = min(psi[celli], max(room/rise, scalar(0)));
            }
        });
    }
    stencil_.halo().fill(psi.data(), 1);
    return psi;
}


Foam::vectorField Foam::fsbi::limitedGradient
(
    const meshStencil& stencil, const scalarField& c
)
{
    const label n = stencil.mesh().nCells();
    scalarField all(c);
    all.setSize(n + stencil.halo().size(), 0);
    stencil.halo().fill(all.data(), 1);
    const cellGradients gradients(stencil);
    vectorField g;
    gradients.set(all, 1, g);
    g = gradients.limits(all, g)*g;
    g.setSize(n);
    return g;
}
