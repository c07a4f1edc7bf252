/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticBlock.H"
#include "asVectors.H"
#include "compactPressures.H"

Foam::fsbi::elasticBlock::elasticBlock
(
    const elasticRows& body,
    const momentumEquation& momentum,
    const label firstRow
)
:
    body_(body),
    elastic_(*body.elastic),
    stencil_(elastic_.stencil()),
    momentum_(momentum),
    stokes_(momentum.viscous()),
    firstRow_(firstRow),
    pressure_(elastic_.state().mixed() ? stencil_.vertices().size() : 0, Zero)
{}


Foam::scalar Foam::fsbi::elasticBlock::halfCoeff(const label ghost) const
{
    const label i = stencil_.firstBoundary() + ghost;
    return
        2*elastic_.state().stiffness()*stencil_.compact()[i]
       /body_.velocityCoeff;
}


Foam::label Foam::fsbi::elasticBlock::fluidCell(const label i) const
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    return mesh.faceOwner()[mesh.nInternalFaces() + i];
}


Foam::label Foam::fsbi::elasticBlock::solidCell(const label i) const
{
    const fvMesh& mesh = stencil_.mesh();
    return mesh.faceOwner()[mesh.nInternalFaces() + i];
}


void Foam::fsbi::elasticBlock::setSurface(const globalIndex& rows)
{
    // columns and coefficients by number; doubles hold columns exactly
    vectorField fluid(body_.fluid.nFaces, Zero);
    vectorField solid(body_.solid.nFaces, Zero);
    forAll(body_.fluid.faces, i)
    {
        const label b = body_.fluid.faces[i];
        fluid[body_.fluid.faceNumbers[i]] =
            vector(stokes_.wallCoeff(b), rows.toGlobal(fluidCell(b)), 0);
    }
    forAll(body_.solid.faces, i)
    {
        const label b = body_.solid.faces[i];
        const bool held =
            elastic_.boundary().kinds()[b] == solidBoundary::displacement;
        solid[body_.solid.faceNumbers[i]] = vector
        (
            held ? 0 : halfCoeff(stencil_.ghostOf()[b]),
            rows.toGlobal(firstRow_ + solidCell(b)), 0
        );
    }
    surfaceSide::sum(fluid);
    surfaceSide::sum(solid);
    fluidK_ = fluid.component(vector::X);
    solidK_ = solid.component(vector::X);
    springK_ =
        body_.springs.size()
      ? scalarField(body_.springs/body_.velocityCoeff)
      : scalarField(solid.size(), Zero);
    sumK_ = solidK_ + springK_;
    parts_ = labelListList(solid.size());
    fluidColumn_.setSize(fluid.size());
    solidColumn_.setSize(solid.size());
    forAll(fluid, i)
    {
        const label t = body_.cut.parent(i);
        parts_[t].append(i);
        sumK_[t] += fluidK_[i];
        fluidColumn_[i] = label(fluid[i].y() + 0.5);
    }
    forAll(solid, t)
    {
        solidColumn_[t] = label(solid[t].y() + 0.5);
    }
}


void Foam::fsbi::elasticBlock::addBody
(
    const globalIndex& rows, compactEntries& entries
) const
{
    scalarList column(stencil_.firstGhost());
    for (label i = 0; i < stencil_.nCells(); ++i)
    {
        column[i] = rows.toGlobal(firstRow_ + i);
        entries.add(column[i], column[i], body_.mass[i]/body_.velocityCoeff);
    }
    stencil_.halo().fill(column.data(), 1);
    for (label i = 0; i < stencil_.firstBoundary(); ++i)
    {
        const label P = column[stencil_.owner()[i]];
        const label N = column[stencil_.neighbour()[i]];
        const scalar k =
            elastic_.state().stiffness()*stencil_.compact()[i]
           /body_.velocityCoeff;
        entries.link(P, N, k);
        if (stencil_.neighbour()[i] < stencil_.nCells())
        {
            entries.link(N, P, k);
        }
    }
    for (label g = 0; g < stencil_.nGhosts(); ++g)
    {
        const label P =
            column[stencil_.owner()[stencil_.firstBoundary() + g]];
        const auto kind = elastic_.boundary().kindOf(g);
        const scalar part =
            kind == solidBoundary::displacement ? 1
          : kind == solidBoundary::symmetry ? 1.0/3
          : 0;
        entries.add(P, P, part*halfCoeff(g));
    }
}


void Foam::fsbi::elasticBlock::addLinks
(
    const globalIndex& rows, compactEntries& entries
) const
{
    forAll(body_.fluid.faces, i)
    {
        const label number = body_.fluid.faceNumbers[i];
        const label t = body_.cut.parent(number);
        if (solidK_[t] > 0)
        {
            const label row =
                rows.toGlobal(fluidCell(body_.fluid.faces[i]));
            const scalar K = fluidK_[number]/sumK_[t];
            // instead of a wall's coefficient
            entries.add(row, row, K*springK_[t] - fluidK_[number]);
            entries.link(row, solidColumn_[t], K*solidK_[t]);
            for (const label other : parts_[t])
            {
                if (other != number)
                {
                    entries.link(row, fluidColumn_[other], K*fluidK_[other]);
                }
            }
        }
    }
    forAll(body_.solid.faces, i)
    {
        const label t = body_.solid.faceNumbers[i];
        if (solidK_[t] > 0)
        {
            const label row =
                rows.toGlobal(firstRow_ + solidCell(body_.solid.faces[i]));
            const scalar K = solidK_[t]/sumK_[t];
            entries.add(row, row, K*springK_[t]);
            for (const label number : parts_[t])
            {
                entries.link(row, fluidColumn_[number], K*fluidK_[number]);
            }
        }
    }
}


void Foam::fsbi::elasticBlock::addEntries
(
    const globalIndex& rows, compactEntries& entries
)
{
    volume_ = gSum(body_.volumes);
    free_ = !solidBoundary::hold(elastic_.boundary().kinds());
    spin_ = sphereResistance(body_, momentum_).spin;
    setSurface(rows);
    addBody(rows, entries);
    addLinks(rows, entries);
}


Foam::scalar Foam::fsbi::elasticBlock::room() const
{
    const solidMaterial& law = elastic_.state().material();
    if (law.flows() || max(solidK_) <= 0)
    {
        return 0;
    }
    const scalar bulk = law.lambda() + 2*elastic_.state().shearModulus()/3;
    return body_.velocityCoeff*volume_/bulk;
}


void Foam::fsbi::elasticBlock::addPressures
(
    const scalar* r, scalar* z, vectorField& rhs, vectorField& force
) const
{
    const auto add = [&](const label i, const vector& pull)
    {
        if (elastic_.boundary().kindAt(i) == solidBoundary::traction)
        {
            force[i - stencil_.firstBoundary()] += pull;
            return;
        }
        rhs[firstRow_ + stencil_.owner()[i]] -= pull;
        if (stencil_.neighbour()[i] < stencil_.nCells())
        {
            rhs[firstRow_ + stencil_.neighbour()[i]] += pull;
        }
    };
    compactPressures(elastic_, r, z, pressure_, add);
}


void Foam::fsbi::elasticBlock::begin
(
    const scalar* r, const scalarList& fluidPressure,
    scalar* z, vectorField& rhs
) const
{
    const label nCells = stencil_.nCells();
    const vector* row = asVectors(r);
    std::copy_n(row, nCells, rhs.begin() + firstRow_);
    SubList<vector> cells(rhs, nCells, firstRow_);
    elastic_.shareJoints(r, cells);

    // what ghosts leave to the surface, or to cells where it is held
    vectorField force(stencil_.nGhosts(), Zero);
    forAll(force, g)
    {
        const vector& ghost = row[nCells + g];
        const label i = stencil_.firstBoundary() + g;
        switch (elastic_.boundary().kindOf(g))
        {
            case solidBoundary::traction:
                force[g] = elastic_.boundary().ghostForce(g, ghost);
                break;
            case solidBoundary::displacement:
                rhs[firstRow_ + stencil_.owner()[i]] +=
                    elastic_.state().stiffness()*stencil_.compact()[i]*ghost;
                break;
            default:
                break;
        }
    }
    addPressures(r, z, rhs, force);
    turn(fluidPressure, cells);
    share(force, fluidPressure, rhs);
}


void Foam::fsbi::elasticBlock::turn
(
    const scalarList& fluidPressure, UList<vector>& forces
) const
{
    omega_ = Zero;
    cells_ = body_.places();
    if (!free_)
    {
        return;
    }
    centre_ = gSum(body_.volumes*cells_)/volume_;
    vector torque(Zero);
    forAll(forces, i)
    {
        torque += (cells_[i] - centre_) ^ forces[i];
    }
    const fvMesh& mesh = stokes_.stencil().mesh();
    forAll(body_.fluid.faces, i)
    {
        const label b = body_.fluid.faces[i];
        const label facei = mesh.nInternalFaces() + b;
        torque +=
            (mesh.faceCentres()[facei] - centre_)
          ^ (fluidPressure[fluidCell(b)]*mesh.faceAreas()[facei]);
    }
    reduce(torque, sumOp<vector>());
    const scalar mu = stokes_.mu();
    const scalar k = elastic_.state().stiffness()/body_.velocityCoeff;
    omega_ = k/((k + 3*mu)*spin_)*torque;
    forAll(forces, i)
    {
        forces[i] -= body_.mass[i]/body_.velocityCoeff*turning(cells_[i]);
    }
}


void Foam::fsbi::elasticBlock::share
(
    const vectorField& force, const scalarList& fluidPressure, vectorField& rhs
) const
{
    const fvMesh& mesh = stokes_.stencil().mesh();
    const label n = body_.solid.nFaces;
    vectorField sums(2*n, Zero);
    forAll(body_.solid.faces, i)
    {
        sums[body_.solid.faceNumbers[i]] =
            force[stencil_.ghostOf()[body_.solid.faces[i]]];
    }
    forAll(body_.fluid.faces, i)
    {
        const label b = body_.fluid.faces[i];
        const label number = body_.fluid.faceNumbers[i];
        const label t = body_.cut.parent(number);
        const point& place = mesh.faceCentres()[mesh.nInternalFaces() + b];
        sums[t] +=
            fluidPressure[fluidCell(b)]
           *mesh.faceAreas()[mesh.nInternalFaces() + b]
          - fluidK_[number]*turning(place);
        sums[n + t] += body_.cut.share(number)*place;
    }
    surfaceSide::sum(sums);
    push_ = SubField<vector>(sums, n);
    places_ = SubField<vector>(sums, n, n);

    forAll(body_.fluid.faces, i)
    {
        const label b = body_.fluid.faces[i];
        const label number = body_.fluid.faceNumbers[i];
        const label t = body_.cut.parent(number);
        if (solidK_[t] > 0)
        {
            rhs[fluidCell(b)] +=
                fluidK_[number]
               *(
                    push_[t]/sumK_[t]
                  + turning(mesh.faceCentres()[mesh.nInternalFaces() + b])
                );
        }
    }
    forAll(body_.solid.faces, i)
    {
        const label b = body_.solid.faces[i];
        const label t = body_.solid.faceNumbers[i];
        if (solidK_[t] > 0)
        {
            rhs[firstRow_ + solidCell(b)] +=
                solidK_[t]/sumK_[t]*push_[t] - force[stencil_.ghostOf()[b]];
        }
    }
}


void Foam::fsbi::elasticBlock::end
(
    const scalar* r, const vectorField& velocity, scalar* z
) const
{
    const label nCells = stencil_.nCells();
    const vector* row = asVectors(r);
    vector* u = asVectors(z);
    for (label i = 0; i < nCells; ++i)
    {
        u[i] =
            (velocity[firstRow_ + i] + turning(cells_[i]))
           /body_.velocityCoeff;
    }
    std::copy_n(row + nCells, stencil_.nGhosts(), u + nCells);
    elastic_.boundary().followCells(u);
    elastic_.followCells(r, UList<vector>(u, nCells), z);

    vectorField pulled(push_.size(), Zero);
    forAll(body_.fluid.faces, i)
    {
        const label number = body_.fluid.faceNumbers[i];
        pulled[body_.cut.parent(number)] +=
            fluidK_[number]*velocity[fluidCell(body_.fluid.faces[i])];
    }
    surfaceSide::sum(pulled);
    forAll(body_.solid.faces, i)
    {
        const label b = body_.solid.faces[i];
        const label t = body_.solid.faceNumbers[i];
        if (solidK_[t] > 0)
        {
            const vector& vs = velocity[firstRow_ + solidCell(b)];
            const vector vb
            (
                (solidK_[t]*vs + pulled[t] + push_[t])/sumK_[t]
              + turning(places_[t])
            );
            u[nCells + stencil_.ghostOf()[b]] =
                (2*vb - vs - turning(cells_[solidCell(b)]))
               /body_.velocityCoeff;
        }
    }
}
