/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "scheduledJacobi.H"
#include "checkedDictionary.H"
#include "fvMesh.H"
#include "laplaceSymbol.H"
#include "mathematicalConstants.H"
#include "PrecisionAdaptor.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(scheduledJacobi, 0);

static const lduMatrix::smoother::
    addsymMatrixConstructorToTable<scheduledJacobi> addSymmetric_;

static const lduMatrix::smoother::
    addasymMatrixConstructorToTable<scheduledJacobi> addAsymmetric_;


// The entries in fvSolution of a field or, of "Ux", of the field "U"
static const dictionary& smootherEntries(const fvMesh& mesh, word field)
{
    const dictionary& solvers = mesh.solutionDict().subDict("solvers");
    const bool last =
        mesh.data::lookupOrDefault<bool>("finalIteration", false);
    if (!solvers.found(field) && !solvers.found(field + "Final"))
    {
        field.resize(field.size() - 1);
    }
    const dictionary& solver =
        mesh.solverDict(last ? word(field + "Final") : field);
    const entry& e = solver.lookupEntry("smoother", keyType::LITERAL);
    if (!e.isDict())
    {
        FatalIOErrorInFunction(solver)
            << "scheduledJacobi needs to know its factors: write"
            << " 'smoother { smoother scheduledJacobi; factors auto; }'"
            << exit(FatalIOError);
    }
    return e.dict();
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalarList Foam::fsbi::scheduledJacobi::factors(const dictionary& dict)
{
    const checkedDictionary entries(dict);
    entries.found("smoother");
    const label steps = entries.getOrDefault<label>("steps", 4);
    const scalar phiMin =
        entries.positive("phiMin", constant::mathematical::piByTwo);
    const vector spacing =
        entries.getOrDefault<vector>("spacing", vector::one);
    scalarList factors;
    bool best = !entries.found("factors");
    if (!best)
    {
        ITstream& is = dict.lookup("factors");
        best = is.size() == 1 && is[0].isWord() && is[0].wordToken() == "auto";
        if (!best)
        {
            factors = dict.get<scalarList>("factors");
        }
    }
    entries.finish();
    if
    (
        best ? steps < 1 || phiMin >= constant::mathematical::pi
            || cmptMin(spacing) < 0 || cmptMax(spacing) <= 0
             : factors.empty()
    )
    {
        FatalIOErrorInFunction(dict)
            << "scheduledJacobi needs factors (a list or auto), steps >= 1,"
            << " phiMin below pi, a spacing of at least one direction"
            << exit(FatalIOError);
    }
    if (best)
    {
        factors = bestFactors(steps, laplaceSymbol(spacing).range(phiMin, true));
    }
    return factors;
}


Foam::fsbi::scheduledJacobi::scheduledJacobi
(
    const word& fieldName,
    const lduMatrix& matrix,
    const FieldField<Field, scalar>& interfaceBouCoeffs,
    const FieldField<Field, scalar>& interfaceIntCoeffs,
    const lduInterfaceFieldPtrsList& interfaces
)
:
    lduMatrix::smoother
    (
        fieldName, matrix, interfaceBouCoeffs, interfaceIntCoeffs, interfaces
    ),
    inverse_(matrix.diag().size())
{
    // GAMG makes the smoother of the finest level first
    static HashTable<scalarList> ofFinest;
    const fvMesh* mesh = dynamic_cast<const fvMesh*>(&matrix.mesh());
    if (mesh)
    {
        ofFinest.set(fieldName, factors(smootherEntries(*mesh, fieldName)));
    }
    factors_ = ofFinest[fieldName];
    forAll(inverse_, i)
    {
        inverse_[i] = 1/matrix.diag()[i];
    }
}


void Foam::fsbi::scheduledJacobi::smooth
(
    solveScalarField& psi,
    const scalarField& source,
    const direction cmpt,
    const label nSweeps
) const
{
    scalarSmooth
    (
        psi, ConstPrecisionAdaptor<solveScalar, scalar>(source)(), cmpt, nSweeps
    );
}


void Foam::fsbi::scheduledJacobi::scalarSmooth
(
    solveScalarField& psi,
    const solveScalarField& source,
    const direction cmpt,
    const label nSweeps
) const
{
    solveScalarField product(psi.size());
    for (label sweep = 0; sweep < nSweeps; ++sweep)
    {
        for (const scalar omega : factors_)
        {
            matrix_.Amul(product, psi, interfaceBouCoeffs_, interfaces_, cmpt);
            forAll(psi, i)
            {
                psi[i] += omega*inverse_[i]*(source[i] - product[i]);
            }
        }
    }
}
