/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elasticParts.H"
#include "bodyShape.H"
#include "bodyState.H"
#include "OStringStream.H"
#include "quaternion.H"
#include "Tuple2.H"

void Foam::fsbi::elasticParts::read(const dictionary& dict)
{
    DynamicList<word> names;
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << e.keyword() << "' is no dictionary: 'parts' has"
                << " one for each part of the body, with its 'shape'"
                << exit(FatalIOError);
        }
        names.append(e.keyword());
        add(e.keyword(), e.dict());
    }
    names_.transfer(names);
    OStringStream os;
    os.precision(17);
    dict.write(os, false);
    text_ = os.str();
}


void Foam::fsbi::elasticParts::add(const word& name, const dictionary& dict)
{
    const checkedDictionary entries(dict);
    const autoPtr<bodyShape> shape(bodyShape::New(entries.subDict("shape")));
    const point position(entries.getOrDefault<point>("position", Zero));
    const Tuple2<vector, scalar> turned(orientationOf(entries));
    entries.finish();
    surfaces_.push_back
    (
        shape->triangulate().transformed
        (
            mag(turned.first()) > 0
          ? quaternion(turned.first()/mag(turned.first()), turned.second()).R()
          : tensor::I,
            position
        )
    );
    surfaces_.back().check("part '" + name + "'");
}


void Foam::fsbi::elasticParts::check
(
    const word& body, const bodySurface& around, const label n
) const
{
    for (const point& p : surfaces_[n].points())
    {
        label inside = around.winding(p) > 0.5 ? -1 : n;
        forAll(names_, i)
        {
            if (i != n && surfaces_[i].winding(p) > 0.5)
            {
                inside = i;
            }
        }
        if (inside >= 0)
        {
            FatalErrorInFunction
                << "Part '" << names_[n] << "' of body '" << body << "' in"
                << " constant/bodies reaches, at " << p << " in the frame of"
                << " the body, "
                << (
                       inside == n
                     ? string("out of the body")
                     : string("into part '" + names_[inside] + "'")
                   ).c_str()
                << ": parts lie inside the body and outside each other"
                << exit(FatalError);
        }
    }
}


std::vector<Foam::fsbi::bodySurface> Foam::fsbi::elasticParts::within
(
    const word& body, const bodySurface& around, const tensor& turned,
    const point& position
) const
{
    std::vector<bodySurface> placed;
    forAll(names_, n)
    {
        check(body, around, n);
        placed.push_back(surfaces_[n].transformed(turned, position));
    }
    return placed;
}


Foam::labelList Foam::fsbi::elasticParts::ofCells
(
    const fvMesh& mesh, const tensor& turned, const point& position
) const
{
    labelList result(names_.empty() ? 0 : mesh.nCells(), Zero);
    forAll(names_, n)
    {
        const bodySurface& surface = surfaces_[n];
        const boundBox box(surface.bounds());
        label found = 0;
        forAll(result, celli)
        {
            const point p(turned.T() & (mesh.cellCentres()[celli] - position));
            if (box.contains(p) && surface.winding(p) > 0.5)
            {
                result[celli] = n + 1;
                ++found;
            }
        }
        if (!returnReduce(found, sumOp<label>()))
        {
            FatalErrorInFunction
                << "Part '" << names_[n] << "' of body '" << mesh.name()
                << "' in constant/bodies has no cell of the body's mesh"
                << exit(FatalError);
        }
    }
    if (names_.size())
    {
        checkSurface(mesh, result);
    }
    return result;
}


void Foam::fsbi::elasticParts::checkSurface
(
    const fvMesh& mesh, const labelUList& ofCells
) const
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        for (label i = 0; !pp.coupled() && i < pp.nPoints(); ++i)
        {
            for (const label celli : mesh.pointCells()[pp.meshPoints()[i]])
            {
                if (ofCells[celli])
                {
                    FatalErrorInFunction
                        << "Part '" << names_[ofCells[celli] - 1]
                        << "' of body '" << mesh.name() << "' has cells at the"
                        << " body's surface, at " << pp.localPoints()[i]
                        << ": refine the mesh between them, or move the part"
                        << exit(FatalError);
                }
            }
        }
    }
}
