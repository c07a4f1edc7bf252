/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "couplingScheme.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(couplingScheme, 0);
defineRunTimeSelectionTable(couplingScheme, entries);

//- Difference of the forces on both sides of a surface, over what acts there,
//  that is not round-off: parts of the surface are lost between processors
static const scalar unbalanced = 1e-8;

//- In the order of the solids
static List<elasticRows*> rowsOf(UPtrList<solidRegion>& solids)
{
    List<elasticRows*> rows(solids.size());
    forAll(rows, e)
    {
        rows[e] = &solids[e].rows();
    }
    return rows;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::couplingScheme::couplingScheme
(
    fluidRegion& fluid,
    UPtrList<solidRegion>& solids,
    const dictionary& dict
)
:
    lagged_
    (
        checkedDictionary(dict).choice
        (
            "geometry", {"implicit", "lagged"}, "implicit"
        ) == "lagged"
    ),
    fluid_(fluid),
    solids_(solids),
    elastic_(rowsOf(solids))
{}


Foam::autoPtr<Foam::fsbi::couplingScheme> Foam::fsbi::couplingScheme::New
(
    fluidRegion& fluid, UPtrList<solidRegion>& solids
)
{
    const dictionary dict
    (
        fluid.mesh().solutionDict().subOrEmptyDict("coupling")
    );
    const word scheme
    (
        checkedDictionary(dict).choice
        (
            "scheme", entriesConstructorTablePtr_->sortedToc(), "monolithic"
        )
    );
    return entriesConstructorTablePtr_->cfind(scheme)()(fluid, solids, dict);
}


Foam::fsbi::outcome Foam::fsbi::couplingScheme::moveMesh()
{
    return lagged_ || fluid_.still() ? outcome() : fluid_.move();
}


Foam::fsbi::outcome Foam::fsbi::couplingScheme::keepApart
(
    const scalar most, List<bodyRows>& rows
)
{
    outcome moved;
    if (apart_->limit(fluid_.acting(), most, rows) && !fluid_.still())
    {
        fluid_.stay(true);
        apart_->atStart([&]{ moved = fluid_.move(); });
    }
    return moved;
}


Foam::List<Foam::vectorField> Foam::fsbi::couplingScheme::effectForces
(
    const UList<bodyRows>& rows, List<vectorField>& cells
) const
{
    const loads::onBodies all(fluid_.effectForces(rows));
    List<vectorField> forces(solids_.size());
    cells.setSize(solids_.size());
    forAll(forces, e)
    {
        const label bodyi = fluid_.nRigid() + e;
        forces[e].setSize(elastic_[e]->elastic->boundary().kinds().size());
        forces[e] = Zero;
        cells[e].clear();
        if (all.triangles.size())
        {
            elastic_[e]->solid.addToFaces(all.triangles[bodyi], forces[e]);
        }
        if (all.points.size() && all.points[bodyi].size())
        {
            cells[e].setSize(elastic_[e]->volumes.size(), Zero);
            elastic_[e]->addPointForces
            (
                all.points[bodyi], cells[e], forces[e]
            );
        }
    }
    return forces;
}


Foam::vectorField Foam::fsbi::couplingScheme::fluidForce
(
    const label solidi
) const
{
    const elasticRows& body = *elastic_[solidi];
    const vectorField onBody
    (
        body.surfaceForce(body.fluidForces(fluid_.traction()))
    );
    vector onFluid(Zero);
    scalar size = 0;
    for (const label i : body.fluid.faces)
    {
        onFluid += fluid_.traction()[i];
        size += mag(fluid_.traction()[i]);
    }
    reduce(onFluid, sumOp<vector>());
    reduce(size, sumOp<scalar>());
    const vector difference(onFluid + gSum(onBody));
    if (mag(difference) > unbalanced*size)
    {
        FatalErrorInFunction
            << "The forces on both sides of the surface of body '"
            << solids_[solidi].name() << "' differ by " << difference
            << abort(FatalError);
    }
    return onBody;
}


Foam::fsbi::outcome Foam::fsbi::couplingScheme::advance
(
    List<bodyRows>& rows, List<sixVector>& loads
)
{
    report_ = solverReport();
    for (solidRegion& solid : solids_)
    {
        solid.setRows();
        if (!solid.follow())
        {
            solid.forget();
            solid.follow();
        }
    }
    fluid_.stay(apart_ && apart_->hold(rows));
    const outcome followed(fluid_.follow());
    if (!followed)
    {
        return followed;
    }
    outcome solved(solve(rows));
    if (!solved)
    {
        for (solidRegion& solid : solids_)
        {
            solved.reason += solid.failureWarning();
        }
        return solved;
    }
    return finish(rows, loads);
}


Foam::fsbi::outcome Foam::fsbi::couplingScheme::finish
(
    List<bodyRows>& rows, List<sixVector>& loads
)
{
    fluid_.finish(rows, elastic_, loads);
    List<vectorField> cells;
    List<vectorField> others(effectForces(rows, cells));
    outcome taken;
    for (label e = 0; taken && e < solids_.size(); ++e)
    {
        taken = solids_[e].finish(fluidForce(e), others[e], cells[e]);
    }
    return taken;
}
