/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exactError.H"
#include "addToRunTimeSelectionTable.H"
#include "volFields.H"
#include "pointFields.H"
#include "OFstream.H"
#include "OSspecific.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(exactError, 0);
    addToRunTimeSelectionTable(functionObject, exactError, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::exactError::exactError
(
    const word& name, const Time& runTime, const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    solution_(exactSolution::New(mesh_))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

template<class Type, class Exact>
Foam::fsbi::exactError::norms Foam::fsbi::exactError::compare
(
    const string& field,
    const UList<Type>& values,
    const pointField& points,
    const scalarField& weights,
    const Exact& exact
)
{
    scalar error2 = 0, exact2 = 0, maxError = 0, maxExact = 0;
    forAll(points, i)
    {
        const Type reference(exact(points[i]));
        const scalar error = mag(values[i] - reference);
        error2 += weights[i]*sqr(error);
        exact2 += weights[i]*magSqr(reference);
        maxError = max(maxError, error);
        maxExact = max(maxExact, mag(reference));
    }
    reduce(error2, sumOp<scalar>());
    reduce(exact2, sumOp<scalar>());
    reduce(maxError, maxOp<scalar>());
    reduce(maxExact, maxOp<scalar>());
    return
    {
        field,
        Foam::sqrt(error2/max(exact2, ROOTVSMALL)),
        maxError/max(maxExact, ROOTVSMALL)
    };
}


Foam::scalarField Foam::fsbi::exactError::vertexVolumes() const
{
    scalarField volumes(mesh_.nPoints(), Zero);
    forAll(mesh_.cellPoints(), celli)
    {
        const labelList& vertices = mesh_.cellPoints()[celli];
        for (const label v : vertices)
        {
            volumes[v] += mesh_.V()[celli]/vertices.size();
        }
    }
    return volumes;
}


Foam::DynamicList<Foam::fsbi::exactError::norms>
Foam::fsbi::exactError::errors() const
{
    const scalar time = mesh_.time().value();
    const pointField& centres = mesh_.cellCentres();
    const scalarField& volumes = mesh_.cellVolumes();
    const auto stress = [&](const point& X)
    {
        return solution_->CauchyStress(X, time);
    };
    const auto displacement = [&](const point& X)
    {
        return solution_->displacement(X, time);
    };
    DynamicList<norms> all;
    all.append
    (
        compare
        (
            "D", mesh_.lookupObject<volVectorField>("D"), centres, volumes,
            displacement
        )
    );
    const auto* vertices = mesh_.findObject<pointVectorField>("pointD");
    if (vertices)
    {
        all.append
        (
            compare
            (
                "pointD", *vertices, mesh_.points(), vertexVolumes(),
                displacement
            )
        );
    }
    if (const auto* sigma = mesh_.findObject<volSymmTensorField>("sigma"))
    {
        all.append(compare("sigma", *sigma, centres, volumes, stress));
        const scalarField zz(sigma->primitiveField().component(symmTensor::ZZ));
        all.append
        (
            compare
            (
                "sigmazz", zz, centres, volumes,
                [&](const point& X) { return stress(X).zz(); }
            )
        );
    }
    const auto* recovered = mesh_.findObject<pointSymmTensorField>("pointSigma");
    if (recovered)
    {
        all.append
        (
            compare
            (
                "pointSigma", *recovered, mesh_.points(), vertexVolumes(), stress
            )
        );
    }
    return all;
}


void Foam::fsbi::exactError::writeTable
(
    const label nCells, const scalar h, const UList<norms>& all
) const
{
    const Time& clock = mesh_.time();
    const fileName folder
    (
        clock.globalPath()/"postProcessing"/name()/clock.timeName()
    );
    mkDir(folder);
    OFstream file(folder/"errors.csv");
    file.precision(10);
    file<< "cells,h";
    for (const norms& n : all)
    {
        file<< ',' << n.field.c_str() << "_l2,"
            << n.field.c_str() << "_max";
    }
    file<< nl << nCells << ',' << h;
    for (const norms& n : all)
    {
        file<< ',' << n.l2 << ',' << n.max;
    }
    file<< endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::fsbi::exactError::write()
{
    const DynamicList<norms> all(errors());
    const label nCells = returnReduce(mesh_.nCells(), sumOp<label>());
    const scalar h = Foam::cbrt(gSum(mesh_.cellVolumes())/nCells);
    Info<< type() << ' ' << name() << ": " << nCells << " cells, h " << h;
    for (const norms& n : all)
    {
        Info<< ", " << n.field.c_str() << " l2 " << n.l2 << " max " << n.max;
    }
    Info<< endl;
    if (Pstream::master())
    {
        writeTable(nCells, h, all);
    }
    return true;
}
