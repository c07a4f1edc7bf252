/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fourthOrderElastic.H"
#include "asVectors.H"
#include "cellMoments.H"
#include "meanValues.H"
#include "processorPolyPatch.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

//- Of what the fits do not explain, over mu
static const scalar stabilisation = 4;

//- Numbers a vertex in fitted::slopes
static const label nSlopes = 12*nQuadratic;


//- The derivative of which monomial gives this one, and how many times
struct antiderivative
{
    label monomial;
    scalar factor;
};

static FixedList<FixedList<antiderivative, 3>, nQuadratic> antiderivatives()
{
    FixedList<FixedList<antiderivative, 3>, nQuadratic> result;
    for (label m = 0; m < nQuadratic; ++m)
    {
        for (label i = 0; i < 3; ++i)
        {
            label k = 0;
            const auto is = [&](const label j)
            {
                return
                    cubicExponents[k][j] == cubicExponents[m][j] + (i == j);
            };
            while (!is(0) || !is(1) || !is(2))
            {
                ++k;
            }
            result[m][i] = {k, scalar(cubicExponents[k][i])};
        }
    }
    return result;
}


//- Gradients of the polynomials with coefficients c
fsbiWide static void setSlopes
(
    const label nVertices, const scalar* c, const scalar* perLength,
    const antiderivative* of, scalar* slopes
)
{
    for (label v = 0; v < nVertices; ++v)
    {
        for (label j = 0; j < 3*nQuadratic; ++j)
        {
            four(slopes + nSlopes*v + 4*j) =
                perLength[v]*of[j].factor
               *four(c + cubicFits::nCoefficients*v + 4*of[j].monomial);
        }
    }
}


//- Add weight times the gradient of a vertex's polynomial at d, lengths in h
fsbiInlined static void addGradient
(
    const scalar weight, const vector& d, const scalar* slopes,
    fourNumbers& x, fourNumbers& y, fourNumbers& z
)
{
    const scalar a[nQuadratic] =
    {
        weight, weight*d.x(), weight*d.y(), weight*d.z(),
        weight*d.x()*d.x(), weight*d.x()*d.y(), weight*d.x()*d.z(),
        weight*d.y()*d.y(), weight*d.y()*d.z(), weight*d.z()*d.z()
    };
    for (label m = 0; m < nQuadratic; ++m)
    {
        x += a[m]*four(slopes + 12*m);
        y += a[m]*four(slopes + 12*m + 4);
        z += a[m]*four(slopes + 12*m + 8);
    }
}


//- At the points of faces: means of the gradients of the faces' vertices
fsbiWide static void setGradients
(
    const label nFaces, const label* faceStart, const label* faceVertex,
    const label* pointStart, const point* points,
    const point* vertices, const scalar* perLength, const scalar* slopes,
    tensor* gradient
)
{
    for (label i = 0; i < nFaces; ++i)
    {
        const scalar weight = 1.0/(faceStart[i + 1] - faceStart[i]);
        for (label k = pointStart[i]; k < pointStart[i + 1]; ++k)
        {
            fourNumbers x = {0, 0, 0, 0}, y = x, z = x;
            for (label j = faceStart[i]; j < faceStart[i + 1]; ++j)
            {
                const label v = faceVertex[j];
                const scalar s = perLength[v];
                const vector d
                (
                    s*(points[k].x() - vertices[v].x()),
                    s*(points[k].y() - vertices[v].y()),
                    s*(points[k].z() - vertices[v].z())
                );
                addGradient(weight, d, slopes + nSlopes*v, x, y, z);
            }
            gradient[k] = tensor
            (
                x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]
            );
        }
    }
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::fourthOrderElastic::fourthOrderElastic
(
    const fvMesh& mesh,
    const solidMaterial& material,
    const List<solidBoundary::kind>& kinds,
    const constitutiveState::formulation form,
    const bool mixed
)
:
    elasticOperator(mesh, material, kinds, form, mixed),
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
    centreState_(mesh.name(), 0, material, form, mixed),
    boundaryForce_(stencil_.nGhosts(), Zero)
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
    const label nInternal = mesh_.nInternalFaces();
    labelList number(mesh_.nCells());
    forAll(number, celli)
    {
        number[celli] = fits_.toGlobal(celli);
    }
    labelList behind;
    syncTools::swapBoundaryCellList(mesh_, number, behind);

    ownerPlace_.setSize(stencil_.faceVertex().size());
    neighbourPlace_.setSize(ownerPlace_.size());
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label facei = stencil_.face()[i];
        const label ghost = i - stencil_.firstBoundary();
        for (label j = stencil_.faceStart()[i]; j < stencil_.faceStart()[i + 1]; ++j)
        {
            const label v = stencil_.faceVertex()[j];
            ownerPlace_[j] =
                fits_.cellPlace(v, number[mesh_.faceOwner()[facei]]);
            neighbourPlace_[j] =
                ghost >= 0 ? fits_.facePlace(v, ghost)
              : facei < nInternal
              ? fits_.cellPlace(v, number[mesh_.faceNeighbour()[facei]])
              : fits_.cellPlace(v, behind[facei - nInternal]);
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
    static const auto of = antiderivatives();
    setSlopes
    (
        nVertices, values.coefficients.cdata(), fits_.perLength().cdata(),
        of[0].cdata(), values.slopes.begin()
    );
    setGradients
    (
        stencil_.nFaces() + nStrips(), vertexStart_.cdata(),
        vertex_.cdata(), pointStart_.cdata(), points_.cdata(),
        mesh_.points().cdata(), fits_.perLength().cdata(),
        values.slopes.cdata(), values.gradient.begin()
    );
}


Foam::vector Foam::fsbi::fourthOrderElastic::unexplained
(
    const label i, const fitted& values
) const
{
    fourNumbers sum = {0, 0, 0, 0};
    const label end = stencil_.faceStart()[i + 1];
    for (label j = stencil_.faceStart()[i]; j < end; ++j)
    {
        sum +=
            four(values.defects.cdata() + 4*neighbourPlace_[j])
          - four(values.defects.cdata() + 4*ownerPlace_[j]);
    }
    return velocity(sum)/(end - stencil_.faceStart()[i]);
}


template<class Stress>
void Foam::fsbi::fourthOrderElastic::addFaces
(
    const fitted& values, const Stress& stress, vectorField& force, scalar* r
) const
{
    const label nCells = mesh_.nCells();
    const label firstBoundary = stencil_.firstBoundary();
    vector* row = asVectors(r);
    for (label i = 0; i < stencil_.nFaces(); ++i)
    {
        const label P = stencil_.owner()[i];
        const label N = stencil_.neighbour()[i];
        const bool inner = i < firstBoundary;
        const scalar k = (inner ? 1 : 2)*stencil_.compact()[i];
        const vector e(unexplained(i, values));
        const vector n(normalised(stencil_.area()[i]));
        vector T
        (
            k
           *(
                stabilisation*material_.mu()*e
              + material_.lambda()*n*(n & e)
            )
        );
        for (label p = pointStart_[i]; p < pointStart_[i + 1]; ++p)
        {
            T += stress(p);
        }
        if (!inner)
        {
            force[i - firstBoundary] = T;
            continue;
        }
        row[P] -= T;
        if (N < nCells)
        {
            row[N] += T;
        }
    }
}


template<class Act>
void Foam::fsbi::fourthOrderElastic::forStrips
(
    const label ghost, const Act& act
) const
{
    if (surface_)
    {
        for (const stripOfFace& strip : strips_[ghost])
        {
            act(pointStart_[strip.number], strip.sign);
        }
    }
}


template<class Stress>
void Foam::fsbi::fourthOrderElastic::addStrips
(
    const Stress& stress, vectorField& loads
) const
{
    forAll(loads, g)
    {
        if (boundary_.kindOf(g) == solidBoundary::traction)
        {
            forStrips(g, [&](const label p, const scalar sign)
            {
                loads[g] += sign*stress(p);
            });
        }
    }
}


void Foam::fsbi::fourthOrderElastic::addBoundaryRows
(
    const fitted& values,
    const vectorField& force,
    const vectorField& given,
    scalar* r
) const
{
    vector* row = asVectors(r);
    vector* ghostRow = row + mesh_.nCells();
    forAll(force, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const label P = stencil_.owner()[i];
        const scalar* u = values.faces[g].cdata();
        const vector atFace(u[0], u[1], u[2]);
        switch (boundary_.kindOf(g))
        {
            case solidBoundary::displacement:
                row[P] -= force[g];
                ghostRow[g] = 2*(atFace - given[g]);
                break;
            case solidBoundary::traction:
                row[P] -= given[g];
                ghostRow[g] = boundary_.ghostRow(g, force[g] - given[g]);
                break;
            default:
            {
                const vector n(normalised(stencil_.area()[i]));
                const vector normal(n*(n & force[g]));
                row[P] -= normal;
                ghostRow[g] =
                    2*n*(n & atFace) + boundary_.ghostRow(g, force[g] - normal);
            }
        }
    }
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


void Foam::fsbi::fourthOrderElastic::residual
(
    const scalar* x, const solidBoundary& given, scalar* r
)
{
    std::fill_n(r, size(), scalar(0));
    given_ = &given;
    tangentsKnown_ = false;
    fit(x, now_);
    forAll(state_.gradient(), v)
    {
        const scalar* s = now_.slopes.cdata() + nSlopes*v;
        state_.gradient()[v] =
            tensor(s[0], s[4], s[8], s[1], s[5], s[9], s[2], s[6], s[10]);
    }
    state_.evaluate();
    pointState_.gradient() = now_.gradient;
    pointState_.evaluate();
    const auto stress = [this](const label p)
    {
        return pointState_.stress()[p] & areas_[p];
    };
    addFaces(now_, stress, boundaryForce_, r);

    vectorField atGhosts(stencil_.nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        const auto kind = boundary_.kindOf(g);
        if (kind == solidBoundary::displacement)
        {
            atGhosts[g] = given.faces[stencil_.ghostFaces()[g]];
        }
        else if (kind == solidBoundary::traction)
        {
            atGhosts[g] = boundary_.deadLoad(g, given);
            const label i = stencil_.firstBoundary() + g;
            for (label p = pointStart_[i]; p < pointStart_[i + 1]; ++p)
            {
                atGhosts[g] += boundary_.followerLoad
                (
                    g, given, areas_[p], now_.gradient[p]
                );
            }
            forStrips(g, [&](const label p, const scalar sign)
            {
                atGhosts[g] -= sign*boundary_.pressureLoad
                (
                    g, given, areas_[p], now_.gradient[p]
                );
            });
        }
    }
    const vectorField loads(atGhosts);
    addStrips(stress, atGhosts);
    addBoundaryRows(now_, boundaryForce_, atGhosts, r);
    forAll(atGhosts, g)
    {
        if (boundary_.kindOf(g) == solidBoundary::traction)
        {
            boundaryForce_[g] = loads[g];
        }
    }
}


void Foam::fsbi::fourthOrderElastic::setTangents() const
{
    tangents_.setSize(9*points_.size());
    forAll(points_, p)
    {
        for (direction j = 0; j < 9; ++j)
        {
            tensor dH(Zero);
            dH[j] = 1;
            tangents_[9*p + j] = pointState_.tangent(p, dH, 0) & areas_[p];
        }
    }
    tangentsKnown_ = true;
}


void Foam::fsbi::fourthOrderElastic::applyJacobian
(
    const scalar* dx, scalar* dr
) const
{
    if (!tangentsKnown_)
    {
        setTangents();
    }
    std::fill_n(dr, size(), scalar(0));
    fit(dx, along_);
    const auto stress = [this](const label p)
    {
        const tensor& dH = along_.gradient[p];
        vector sum(dH[0]*tangents_[9*p]);
        for (direction j = 1; j < 9; ++j)
        {
            sum += dH[j]*tangents_[9*p + j];
        }
        return sum;
    };
    vectorField force(stencil_.nGhosts(), Zero);
    addFaces(along_, stress, force, dr);

    vectorField atGhosts(stencil_.nGhosts(), Zero);
    forAll(atGhosts, g)
    {
        const label i = stencil_.firstBoundary() + g;
        const bool loaded =
            boundary_.kindOf(g) == solidBoundary::traction
         && boundary_.follows(g, *given_);
        for (label p = pointStart_[i]; loaded && p < pointStart_[i + 1]; ++p)
        {
            atGhosts[g] += boundary_.loadTangent
            (
                g, *given_, areas_[p], now_.gradient[p], along_.gradient[p]
            );
        }
        if (loaded)
        {
            forStrips(g, [&](const label p, const scalar sign)
            {
                atGhosts[g] -= sign*boundary_.pressureTangent
                (
                    g, *given_, areas_[p], now_.gradient[p],
                    along_.gradient[p]
                );
            });
        }
    }
    addStrips(stress, atGhosts);
    addBoundaryRows(along_, force, atGhosts, dr);
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
    return &centreState_;
}


Foam::tmp<Foam::vectorField>
Foam::fsbi::fourthOrderElastic::boundaryForce() const
{
    auto result = tmp<vectorField>::New(boundary_.kinds().size(), Zero);
    UIndirectList<vector>(result.ref(), stencil_.ghostFaces()) = boundaryForce_;
    return result;
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
}
