/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderElastic.H"
#include "asVectors.H"
#include "cellMoments.H"
#include "cubicSlopes.H"
#include "meanValues.H"
#include "processorPolyPatch.H"
#include "syncTools.H"

Foam::fsbi::fourthOrderElastic::fourthOrderElastic
(
    const fvMesh& mesh,
    const solidMaterial& material,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
:
    elasticOperator(mesh, materialParts(material), kinds, form, mixed),
    fits_
    (
        mesh,
        labelList
        (
            SubList<label>
            (
                stencil_.face(), stencil_.nGhosts(), stencil_.firstBoundary()
            )
        )
    ),
    pointState_(mesh.name(), 0, material, form, mixed),
    centreState_(mesh.name(), 0, material, form, mixed)
{
    check(form);
    setSurface();
    setVertices();
    setPlaces();
    setPoints();
    pointState_.setSize(points_.size());
}


void Foam::fsbi::fourthOrderElastic::check
(
    const constitutiveState::formulation form
) const
{
    const char* missing =
        mixed_ ? "'mixed yes'"
      : form != constitutiveState::formulation::totalLagrangian
      ? "formulations other than totalLagrangian"
      : material_.viscosity() > 0 ? "viscosity"
      : nullptr;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (pp.coupled() && !isA<processorPolyPatch>(pp))
        {
            missing = "cyclic patches";
        }
    }
    if (missing)
    {
        FatalErrorInFunction
            << "Order 4 of elastic bodies is not there for " << missing
            << ". Give 'order 2' in 'solid' of system/" << mesh_.name()
            << "/fvSolution" << exit(FatalError);
    }
}


void Foam::fsbi::fourthOrderElastic::setSurface()
{
    const label nInternal = mesh_.nInternalFaces();
    curved_ = boolList(boundary_.kinds().size(), false);
    boolList onSurface(mesh_.nPoints(), false);
    bool triangles = true;
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label b = stencil_.ghostFaces()[g];
        const face& f = mesh_.faces()[nInternal + b];
        curved_[b] = boundary_.kindOf(g) != solidBoundary::symmetry;
        triangles = triangles && f.size() == 3;
        if (curved_[b])
        {
            UIndirectList<bool>(onSurface, f) = true;
        }
    }
    syncTools::syncPointList(mesh_, onSurface, orEqOp<bool>(), false);
    if (returnReduce(triangles, andOp<bool>()))
    {
        DynamicList<label> vertices;
        forAll(onSurface, v)
        {
            if (onSurface[v])
            {
                vertices.append(v);
            }
        }
        surface_.reset
        (
            new curvedWall(mesh_, curved_, vertices, curvedWall::surface())
        );
    }
}


void Foam::fsbi::fourthOrderElastic::setVertices()
{
    vertex_ = stencil_.faceVertex();
    vertexStart_ = stencil_.faceStart();
    for (label j = 0; j < nStrips(); ++j)
    {
        const edge& e = surface_->edges()[j];
        vertex_.append({e.start(), e.end()});
        vertexStart_.append(vertex_.size());
    }
    strips_.setSize(surface_ ? stencil_.nGhosts() : 0);
    forAll(strips_, g)
    {
        const label b = stencil_.ghostFaces()[g];
        const face& f = mesh_.faces()[mesh_.nInternalFaces() + b];
        forAll(f, k)
        {
            const edge e(f.faceEdge(k));
            if (curved_[b])
            {
                const label j = surface_->edgeNumber(e);
                const bool along = surface_->edges()[j].start() == e.start();
                strips_[g].append
                (
                    stripOfFace{stencil_.nFaces() + j, scalar(along ? 1 : -1)}
                );
            }
        }
    }
}


void Foam::fsbi::fourthOrderElastic::setPlaces()
{
    const vertexCells& cells = fits_.cells();
    const labelList other(cells.otherSides());
    ownerPlace_.setSize(stencil_.faceVertex().size());
    neighbourPlace_.setSize(ownerPlace_.size());
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label facei = stencil_.face()[i];
        const label P = cells.toGlobal(mesh_.faceOwner()[facei]);
        const label ghost = i - stencil_.firstBoundary();
        for (label j = stencil_.faceStart()[i]; j < stencil_.faceStart()[i + 1]; ++j)
        {
            const label v = stencil_.faceVertex()[j];
            ownerPlace_[j] = fits_.cellPlace(v, P);
            neighbourPlace_[j] =
                ghost >= 0 ? fits_.facePlace(v, ghost)
              : fits_.cellPlace(v, other[facei]);
        }
    }
}


void Foam::fsbi::fourthOrderElastic::setPoints()
{
    DynamicList<point> points;
    DynamicList<vector> areas;
    pointStart_.setSize(stencil_.nFaces() + nStrips() + 1);
    pointStart_[0] = 0;
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label facei = stencil_.face()[i];
        setFacePoints
        (
            mesh_.points(), mesh_.faces()[facei], mesh_.faceCentres()[facei],
            points, areas
        );
        pointStart_[i + 1] = points.size();
    }
    for (label j = 0; j < nStrips(); ++j)
    {
        const edge& e = surface_->edges()[j];
        const wallStrip strip(surface_->strip(e.start(), e.end()));
        points.append(strip.middle);
        areas.append(strip.area);
        pointStart_[stencil_.nFaces() + j + 1] = points.size();
    }
    points_.transfer(points);
    areas_.transfer(areas);

    offset_ = vectorField(stencil_.nGhosts(), Zero);
    for (label g = 0; surface_ && g < stencil_.nGhosts(); ++g)
    {
        const label b = stencil_.ghostFaces()[g];
        if (curved_[b])
        {
            const label facei = mesh_.nInternalFaces() + b;
            offset_[g] = surface_->toSurface(facei);
        }
    }
}


void Foam::fsbi::fourthOrderElastic::update()
{
    elasticOperator::update();
    fits_.update();
    if (surface_)
    {
        surface_->update();
    }
    setPoints();
}


void Foam::fsbi::fourthOrderElastic::fit
(
    const scalar* x, fitted& values
) const
{
    const label nCells = mesh_.nCells();
    values.cells.setSize(nCells);
    values.faces.setSize(stencil_.nGhosts());
    forAll(values.cells, celli)
    {
        const scalar* u = x + 3*celli;
        values.cells[celli] = {u[0], u[1], u[2], 0};
    }
    forAll(values.faces, g)
    {
        const scalar* uP = x + 3*stencil_.owner()[stencil_.firstBoundary() + g];
        const scalar* uG = x + 3*(nCells + g);
        values.faces[g] =
        {
            0.5*(uP[0] + uG[0]), 0.5*(uP[1] + uG[1]), 0.5*(uP[2] + uG[2]), 0
        };
    }
    const label nVertices = mesh_.nPoints();
    values.coefficients.setSize(cubicFits::nCoefficients*nVertices);
    values.defects.setSize(4*fits_.nPlaces());
    values.slopes.setSize(nSlopes*nVertices);
    values.gradient.setSize(points_.size());
    fits_.fit
    (
        values.cells, values.faces, values.coefficients.begin(),
        values.defects.begin()
    );
    setSlopes
    (
        nVertices, values.coefficients.cdata(), fits_.perLength().cdata(),
        values.slopes.begin()
    );
    setGradients
    (
        stencil_.nFaces() + nStrips(), vertexStart_.cdata(),
        vertex_.cdata(), pointStart_.cdata(), points_.cdata(),
        mesh_.points().cdata(), fits_.perLength().cdata(),
        values.slopes.cdata(), values.gradient.begin()
    );
}


void Foam::fsbi::fourthOrderElastic::set
(
    const displacementFunction& u, scalar* x
) const
{
    vector* row = asVectors(x);
    for (label celli = 0; celli < mesh_.nCells(); ++celli)
    {
        row[celli] = cellMean(mesh_, celli, u);
    }
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label i = stencil_.firstBoundary() + g;
        row[mesh_.nCells() + g] =
            2*u(mesh_.faceCentres()[stencil_.face()[i]])
          - row[stencil_.owner()[i]];
    }
}


Foam::tmp<Foam::scalarField>
Foam::fsbi::fourthOrderElastic::volumesOnFacets() const
{
    tmp<scalarField> result(elasticOperator::volumesOnFacets());
    for (label g = 0; surface_ && g < stencil_.nGhosts(); ++g)
    {
        const label b = stencil_.ghostFaces()[g];
        const label facei = mesh_.nInternalFaces() + b;
        if (curved_[b])
        {
            result.ref()[mesh_.faceOwner()[facei]] +=
                surface_->volumeOnFacet(facei);
        }
    }
    return result;
}


bool Foam::fsbi::fourthOrderElastic::valid() const
{
    const bool atPoints = pointState_.valid();
    return elasticOperator::valid() && atPoints;
}


const Foam::fsbi::constitutiveState*
Foam::fsbi::fourthOrderElastic::atCentres() const
{
    if (centresKnown_)
    {
        return &centreState_;
    }
    const label nCells = mesh_.nCells();
    DynamicList<label> vertices(4*nCells);
    labelList start(nCells + 1, 0);
    for (label celli = 0; celli < nCells; ++celli)
    {
        vertices.append(mesh_.cellPoints()[celli]);
        start[celli + 1] = vertices.size();
    }
    if (centreState_.gradient().size() != nCells)
    {
        centreState_.setSize(nCells);
    }
    setGradients
    (
        nCells, start.cdata(), vertices.cdata(),
        identity(nCells + 1).cdata(), mesh_.cellCentres().cdata(),
        mesh_.points().cdata(), fits_.perLength().cdata(),
        now_.slopes.cdata(), centreState_.gradient().begin()
    );
    centreState_.evaluate();
    centresKnown_ = true;
    return &centreState_;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::fourthOrderElastic::atVertices
(
    const fitted& values
) const
{
    auto result = tmp<vectorField>::New(mesh_.nPoints());
    forAll(result(), v)
    {
        result.ref()[v] = velocity
        (
            four(values.coefficients.cdata() + cubicFits::nCoefficients*v)
        );
    }
    return result;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::fourthOrderElastic::atBoundary
(
    const fitted& values
) const
{
    auto result = tmp<vectorField>::New(boundary_.kinds().size(), Zero);
    forAll(stencil_.ghostFaces(), g)
    {
        const scalar* u = values.faces[g].cdata();
        result.ref()[stencil_.ghostFaces()[g]] = vector(u[0], u[1], u[2]);
    }
    return result;
}


Foam::tmp<Foam::vectorField> Foam::fsbi::fourthOrderElastic::onSurface
(
    const fitted& values
) const
{
    tmp<vectorField> result(atBoundary(values));
    forAll(stencil_.ghostFaces(), g)
    {
        result.ref()[stencil_.ghostFaces()[g]] +=
            meanGradient(stencil_.firstBoundary() + g, values) & offset_[g];
    }
    return result;
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::surfaceDisplacement() const
{
    return onSurface(now_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::surfaceIncrement() const
{
    return onSurface(along_);
}


Foam::tmp<Foam::pointField>
Foam::fsbi::fourthOrderElastic::surfacePoints() const
{
    tmp<pointField> result(surfaceDisplacement());
    forAll(stencil_.ghostFaces(), g)
    {
        const label b = stencil_.ghostFaces()[g];
        result.ref()[b] +=
            mesh_.faceCentres()[mesh_.nInternalFaces() + b] + offset_[g];
    }
    return result;
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::vertexDisplacement() const
{
    return atVertices(now_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::vertexIncrement() const
{
    return atVertices(along_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::boundaryDisplacement() const
{
    return atBoundary(now_);
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::boundaryIncrement() const
{
    return atBoundary(along_);
}


void Foam::fsbi::fourthOrderElastic::endStep()
{
    elasticOperator::endStep();
    pointState_.endStep();
    for (label i = 0; damping_ > 0 && i < stencil_.nFaces(); ++i)
    {
        jumpHistory_[i] = turn(i).T() & jumps_[i].e;
    }
}
