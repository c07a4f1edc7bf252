/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "solidFields.H"
#include "solidConditions.H"
#include "sharedVertices.H"

namespace Foam
{

//- A field that is zero so far, or as saved
template<class FieldType, class Mesh>
static FieldType zeroField
(
    const word& name,
    const Mesh& mesh,
    const dimensionSet& dimensions,
    const bool saved = false
)
{
    return FieldType
    (
        IOobject
        (
            name, mesh.time().timeName(), mesh.thisDb(),
            saved ? IOobject::READ_IF_PRESENT : IOobject::NO_READ
        ),
        mesh,
        dimensioned<typename FieldType::value_type>(dimensions, Zero)
    );
}

} // End namespace Foam


Foam::fsbi::solidFields::solidFields
(
    const fvMesh& mesh, const bool saved, const bool inFluid
)
:
    mesh_(mesh),
    stencil_(mesh),
    sigma_(zeroField<volSymmTensorField>("sigma", mesh, dimPressure)),
    sigmaEq_(zeroField<volScalarField>("sigmaEq", mesh, dimPressure)),
    epsilon_(zeroField<volSymmTensorField>("epsilon", mesh, dimless)),
    J_(zeroField<volScalarField>("J", mesh, dimless)),
    pointD_
    (
        zeroField<pointVectorField>("pointD", pointMesh::New(mesh), dimLength, saved)
    ),
    pointSigma_
    (
        zeroField<pointSymmTensorField>
        (
            "pointSigma", pointMesh::New(mesh), dimPressure
        )
    )
{
    IOobject io("D", mesh.time().timeName(), mesh);
    if (saved)
    {
        io.readOpt() = IOobject::MUST_READ;
        D_.reset(new volVectorField(io, mesh));
        return;
    }
    const dictionary dict(solidConditions::fieldDictionary(mesh, inFluid));
    D_.reset(new volVectorField(io, mesh, dict));
}


template<class Type>
void Foam::fsbi::solidFields::average
(
    const partVertices& vertices,
    const Field<Type>& values,
    GeometricField<Type, fvPatchField, volMesh>& field
) const
{
    const auto mean = [&](const labelUList& points)
    {
        Type sum(Zero);
        for (const label v : points)
        {
            sum += values[v];
        }
        return Type(sum/scalar(points.size()));
    };
    forAll(field, celli)
    {
        field[celli] = mean(vertices.ofCells()[celli]);
    }
    field.correctBoundaryConditions();
    for (auto& pf : field.boundaryFieldRef())
    {
        forAll(pf, i)
        {
            if (!pf.coupled())
            {
                pf[i] = mean(mesh_.faces()[pf.patch().start() + i]);
            }
        }
    }
}


Foam::tmp<Foam::vectorField> Foam::fsbi::solidFields::boundaryD() const
{
    const label first = mesh_.nInternalFaces();
    auto D = tmp<vectorField>::New(mesh_.nFaces() - first, Zero);
    for (const fvPatchVectorField& pf : D_->boundaryField())
    {
        if (!pf.coupled())
        {
            SubField<vector>(D.ref(), pf.size(), pf.patch().start() - first) =
                pf;
        }
    }
    return D;
}


void Foam::fsbi::solidFields::setDisplacement
(
    const vectorField& cells,
    const vectorField& faces,
    const vectorField& vertices
)
{
    D_->primitiveFieldRef() = cells;
    D_->correctBoundaryConditions();
    for (fvPatchVectorField& pf : D_->boundaryFieldRef())
    {
        if (!pf.coupled())
        {
            pf == SubField<vector>
            (
                faces, pf.size(), pf.patch().start() - mesh_.nInternalFaces()
            );
        }
    }
    pointD_.primitiveFieldRef() = vertices;
}


void Foam::fsbi::solidFields::recoverStress()
{
    const haloExchange& halo = stencil_.halo();
    List<symmTensor> cells(mesh_.nCells() + halo.size(), Zero);
    std::copy(sigma_.begin(), sigma_.end(), cells.begin());
    halo.fill(cells.begin()->v_, symmTensor::nComponents);
    const labelList& start = stencil_.vertexStart();
    symmTensorField& recovered = pointSigma_.primitiveFieldRef();
    forAll(recovered, v)
    {
        symmTensor sum(Zero);
        for (label i = start[v]; i < start[v + 1]; ++i)
        {
            sum += stencil_.vertexWeight()[i]*cells[stencil_.vertexCell()[i]];
        }
        recovered[v] = sum;
    }
    sharedVertices::sum<symmTensor::nComponents>
    (
        mesh_, recovered.begin()->v_, halo.size()
    );
}


void Foam::fsbi::solidFields::setStress
(
    const elasticOperator& elastic,
    const bool smallStrain
)
{
    const auto strainOf = [&](const tensor& F)
    {
        return
            smallStrain
          ? symm(F) - symmTensor::I
          : 0.5*(symm(F.T() & F) - symmTensor::I);
    };
    const tensorField& F = elastic.state().deformation();
    const symmTensorField sigma(elastic.state().CauchyStress());
    symmTensorField strain(F.size());
    scalarField J(F.size());
    forAll(F, v)
    {
        strain[v] = strainOf(F[v]);
        J[v] = det(F[v]);
    }
    const partVertices& vertices = elastic.stencil().vertices();
    average(vertices, sigma, sigma_);
    average(vertices, strain, epsilon_);
    average(vertices, J, J_);
    if (const constitutiveState* centres = elastic.atCentres())
    {
        sigma_.primitiveFieldRef() = centres->CauchyStress();
        forAll(sigma_, celli)
        {
            epsilon_[celli] = strainOf(centres->deformation()[celli]);
            J_[celli] = det(centres->deformation()[celli]);
        }
        pointSigma_.primitiveFieldRef() = sigma;
    }
    else
    {
        recoverStress();
    }
    sigmaEq_ = sqrt(1.5*magSqr(dev(sigma_)));
}


void Foam::fsbi::solidFields::setParts(const labelUList& ofCells)
{
    part_.reset(new volScalarField(zeroField<volScalarField>("part", mesh_, dimless)));
    std::copy(ofCells.begin(), ofCells.end(), part_->primitiveFieldRef().begin());
}


void Foam::fsbi::solidFields::write
(
    const std::function<void(const regIOobject&)>& add
) const
{
    add(D_());
    add(sigma_);
    add(sigmaEq_);
    add(epsilon_);
    add(J_);
    add(pointD_);
    add(pointSigma_);
    if (part_)
    {
        add(part_());
    }
}
