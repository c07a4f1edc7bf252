/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "carriedFields.H"
#include "ofAllProcessors.H"
#include "pointSearch.H"
#include "surfaceFields.H"
#include "pointFields.H"

namespace Foam
{
namespace fsbi
{

//- Delete the fields of a kind that the mesh owns
template<class FieldType>
static void erase(const fvMesh& mesh)
{
    for (const word& name : mesh.thisDb().sortedNames<FieldType>())
    {
        auto& field = mesh.thisDb().lookupObjectRef<FieldType>(name);
        if (field.ownedByRegistry())
        {
            field.checkOut();
        }
    }
}

template<class Type>
static void eraseOthers(const fvMesh& mesh)
{
    erase<GeometricField<Type, fvsPatchField, surfaceMesh>>(mesh);
    erase<GeometricField<Type, pointPatchField, pointMesh>>(mesh);
    erase<DimensionedField<Type, volMesh>>(mesh);
    erase<DimensionedField<Type, surfaceMesh>>(mesh);
}

//- Gradients in the cells, of least squares over the neighbours and the middles
//  of boundary faces: OpenFOAM's own takes these along the normal, which is not
//  exact for what is linear
static vectorField gradientOf(const volScalarField& field)
{
    const fvMesh& mesh = field.mesh();
    tensorField moments(mesh.nCells(), Zero);
    vectorField sums(mesh.nCells(), Zero);
    const auto add = [&](const label celli, const vector& d, const scalar by)
    {
        const vector weighted(d/magSqr(d));
        moments[celli] += weighted*d;
        sums[celli] += weighted*by;
    };
    forAll(mesh.neighbour(), f)
    {
        const label o = mesh.owner()[f], n = mesh.neighbour()[f];
        const vector d(mesh.C()[n] - mesh.C()[o]);
        add(o, d, field[n] - field[o]);
        add(n, -d, field[o] - field[n]);
    }
    for (const fvPatchScalarField& pf : field.boundaryField())
    {
        const labelUList& cells = pf.patch().faceCells();
        const scalarField there
        (
            pf.coupled() ? pf.patchNeighbourField()() : scalarField(pf)
        );
        const vectorField way
        (
            pf.coupled()
          ? pf.patch().delta()
          : tmp<vectorField>(pf.patch().Cf() - pf.patch().Cn())
        );
        forAll(cells, i)
        {
            add(cells[i], way[i], there[i] - field[cells[i]]);
        }
    }
    return inv(moments) & sums;
}

//- For each of the positions the nearest of the candidates
static labelList nearestOf(const pointField& candidates, const pointField& x)
{
    labelList nearest(x.size(), -1);
    if (candidates.empty())
    {
        return nearest;
    }
    const pointSearch search(candidates);
    forAll(x, i)
    {
        nearest[i] = search.nearest(x[i]);
    }
    return nearest;
}

} // End namespace fsbi
} // End namespace Foam


Foam::List<Foam::pointField> Foam::fsbi::carriedFields::placesOf
(
    const fvMesh& mesh
)
{
    List<pointField> places(1, mesh.cellCentres());
    for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        places.append(pointField(mesh.boundaryMesh()[i].faceCentres()));
    }
    return places;
}


template<class Type>
Foam::fsbi::carriedFields::carried<Type> Foam::fsbi::carriedFields::valuesOf
(
    const GeometricField<Type, fvPatchField, volMesh>& field
)
{
    const fvMesh& mesh = field.mesh();
    List<vectorField> slopes(pTraits<Type>::nComponents);
    List<vectorField> ofCells(slopes.size());
    forAll(slopes, d)
    {
        slopes[d] = gradientOf(field.component(d)());
        ofCells[d] = ofAllProcessors(slopes[d]);
    }
    carried<Type> all
    {
        field.name(), field.instance(), field.dimensions(),
        List<Field<Type>>(1, ofAllProcessors(field.primitiveField())),
        List<List<vectorField>>(1, ofCells)
    };
    for (label i = 0; i < mesh.boundaryMesh().nNonProcessor(); ++i)
    {
        List<vectorField> beside(slopes.size());
        forAll(slopes, d)
        {
            beside[d] =
                ofAllProcessors(vectorField(slopes[d], mesh.boundary()[i].faceCells()));
        }
        all.values.append(ofAllProcessors(Field<Type>(field.boundaryField()[i])));
        all.gradients.append(beside);
    }
    return all;
}


template<class Type>
void Foam::fsbi::carriedFields::take
(
    fvMesh& mesh, std::vector<carried<Type>>& fields
)
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    for (const word& name : mesh.thisDb().sortedNames<fieldType>())
    {
        auto& field = mesh.thisDb().lookupObjectRef<fieldType>(name);
        if (field.ownedByRegistry())
        {
            fields.push_back(valuesOf(field));
            field.checkOut();
        }
    }
}


template<class Type>
void Foam::fsbi::carriedFields::put
(
    const std::vector<carried<Type>>& fields,
    const UList<pointField>& places,
    const UList<labelList>& nearest,
    fvMesh& mesh
) const
{
    typedef GeometricField<Type, fvPatchField, volMesh> fieldType;
    for (const carried<Type>& old : fields)
    {
        auto* field = new fieldType
        (
            IOobject(old.name, old.instance, mesh), mesh,
            dimensioned<Type>(old.dimensions, Zero)
        );
        forAll(places, group)
        {
            Field<Type> values(old.values[group], nearest[group]);
            const pointField way
            (
                places[group] - pointField(places_[group], nearest[group])
            );
            forAll(old.gradients[group], d)
            {
                const vectorField slope
                (
                    old.gradients[group][d], nearest[group]
                );
                values.replace(d, values.component(d) + (slope & way));
            }
            if (group == 0)
            {
                field->primitiveFieldRef() = values;
            }
            else
            {
                field->boundaryFieldRef()[group - 1] == values;
            }
        }
        field->correctBoundaryConditions();
        mesh.objectRegistry::store(field);
        Info<< ' ' << old.name;
    }
}


Foam::fsbi::carriedFields::carriedFields(fvMesh& mesh)
{
    take(mesh, scalars_);
    take(mesh, vectors_);
    take(mesh, sphericalTensors_);
    take(mesh, symmTensors_);
    take(mesh, tensors_);
    if
    (
        scalars_.size() || vectors_.size() || sphericalTensors_.size()
     || symmTensors_.size() || tensors_.size()
    )
    {
        for (const pointField& mine : placesOf(mesh))
        {
            places_.append(ofAllProcessors(mine));
        }
    }
    eraseOthers<scalar>(mesh);
    eraseOthers<vector>(mesh);
    eraseOthers<sphericalTensor>(mesh);
    eraseOthers<symmTensor>(mesh);
    eraseOthers<tensor>(mesh);
}


void Foam::fsbi::carriedFields::putOn(fvMesh& mesh) const
{
    if (places_.empty())
    {
        return;
    }
    const List<pointField> places(placesOf(mesh));
    labelListList nearest(places.size());
    forAll(places, group)
    {
        nearest[group] = nearestOf(places_[group], places[group]);
    }
    Info<< "Carried over to the new mesh:";
    put(scalars_, places, nearest, mesh);
    put(vectors_, places, nearest, mesh);
    put(sphericalTensors_, places, nearest, mesh);
    put(symmTensors_, places, nearest, mesh);
    put(tensors_, places, nearest, mesh);
    Info<< endl;
}
