/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticRows.H"
#include "asVectors.H"
#include "massRows.H"

Foam::symmTensor Foam::fsbi::momentOfInertia
(
    const scalarField& w, const vectorField& d
)
{
    return gSum(w*(magSqr(d)*symmTensor::I - sqr(d)));
}


Foam::fsbi::surfaceDisplacement Foam::fsbi::surfaceDisplacement::split
(
    const vectorField& both, const surfaceSide& side
)
{
    return
    {
        vectorField(SubField<vector>(both, side.nFaces, side.nPoints)),
        vectorField(SubField<vector>(both, side.nPoints))
    };
}


Foam::pointField Foam::fsbi::elasticRows::places() const
{
    pointField result(centres);
    const vector* u = asVectors(x->cdata());
    forAll(result, celli)
    {
        result[celli] += u[celli];
    }
    return result;
}


void Foam::fsbi::elasticRows::spread(const sixVector& load)
{
    acting.clear();
    if (load == sixVector(scalar(0)))
    {
        return;
    }
    vectorField r(places());
    const scalar V = gSum(volumes);
    r -= gSum(volumes*r)/V;
    const symmTensor J(momentOfInertia(volumes, r));
    acting = volumes*(linear(load)/V + ((inv(J) & angular(load)) ^ r));
}


void Foam::fsbi::elasticRows::addPointForces
(
    const vectorField& points, vectorField& cells, vectorField& faces
) const
{
    vectorField onVertices(elastic->stencil().mesh().nPoints(), Zero);
    vectorField moving(points);
    forAll(moving, i)
    {
        if (heldPoints[i])
        {
            moving[i] = Zero;       // their supports take it
        }
    }
    solid.spreadPoints(moving, onVertices);
    elastic->shareForces(onVertices, cells, faces);
}


void Foam::fsbi::elasticRows::residual(const scalar* x, scalar* r) const
{
    elastic->residual(x, *given, r);
    addMassAndForce(mass, cellForce(), x, r);
}


void Foam::fsbi::elasticRows::applyJacobian(const scalar* dx, scalar* dr) const
{
    elastic->applyJacobian(dx, dr);
    addMass(mass, dx, dr);
}


Foam::fsbi::surfaceDisplacement Foam::fsbi::elasticRows::surface() const
{
    vectorField moving(elastic->surfaceDisplacement());
    for (const label i : solid.faces)
    {
        if (elastic->boundary().kinds()[i] == solidBoundary::displacement)
        {
            moving[i] = given->faces[i];
        }
    }
    surfaceDisplacement d
    {
        solid.collectFaces(moving) + movedFaces,
        solid.collectPoints(elastic->vertexDisplacement()) + movedPoints
    };
    forAll(d.points, i)
    {
        if (heldPoints[i])
        {
            d.points[i] = heldAt[i];
        }
    }
    return d;
}


Foam::fsbi::surfaceDisplacement
Foam::fsbi::elasticRows::surfaceIncrement() const
{
    vectorField moving(elastic->surfaceIncrement());
    for (const label i : solid.faces)
    {
        if (elastic->boundary().kinds()[i] == solidBoundary::displacement)
        {
            moving[i] = Zero;
        }
    }
    surfaceDisplacement d
    {
        solid.collectFaces(moving),
        solid.collectPoints(elastic->vertexIncrement())
    };
    forAll(d.points, i)
    {
        if (heldPoints[i])
        {
            d.points[i] = Zero;
        }
    }
    return d;
}


void Foam::fsbi::elasticRows::setVelocity
(
    const stokesOperator& stokes,
    const surfaceDisplacement& d,
    boundaryValues& values
) const
{
    const surfaceDisplacement v
    (
        parts
        ({
            velocityCoeff*d.faces + knownFaces,
            velocityCoeff*d.points + knownPoints
        })
    );
    fluid.spreadFaces(v.faces, values.faces);
    fluid.spreadPoints(v.points, values.vertices);
    stokes.setOnEdges(fluidPatch, values.vertices);
}


void Foam::fsbi::elasticRows::setFacePoints
(
    const stokesOperator& stokes, boundaryValues& values
) const
{
    vectorField x(elastic->surfacePoints());
    if (returnReduce(x.empty(), andOp<bool>()))
    {
        return;
    }
    for (const label i : solid.faces)
    {
        if (elastic->boundary().kinds()[i] == solidBoundary::displacement)
        {
            x[i] = boundaryValues::nowhere;
        }
    }
    values.facePoints.resize
    (
        stokes.nBoundaryFaces(), boundaryValues::nowhere
    );
    fluid.spreadFaces(solid.collectFaces(x), values.facePoints);
}


void Foam::fsbi::elasticRows::setVelocityIncrement
(
    const stokesOperator& stokes,
    const surfaceDisplacement& ddOfParts,
    boundaryValues& values
) const
{
    fluid.spreadFaces
    (
        vectorField(velocityCoeff*ddOfParts.faces), values.faces
    );
    fluid.spreadPoints
    (
        vectorField(velocityCoeff*ddOfParts.points), values.vertices
    );
    stokes.setOnEdges(fluidPatch, values.vertices);
}


Foam::vectorField Foam::fsbi::elasticRows::surfaceForce
(
    const vectorField& fluidForces
) const
{
    vectorField onFaces(elastic->boundary().kinds().size(), Zero);
    solid.spreadFaces(cut.onTriangles(fluidForces), onFaces);
    return onFaces;
}
