/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "boxMesh.H"
#include "cellModel.H"
#include "cellShape.H"
#include "IStringStream.H"

namespace Foam
{
namespace fsbi
{

static label index(const Vector<label>& n, label i, label j, label k)
{
    return i + (n.x() + 1)*(j + (n.y() + 1)*k);
}


// The quadrilaterals of one side, normal out
static faceList side(const Vector<label>& n, const direction d, const bool upper)
{
    const direction a = (d + 1) % 3, b = (d + 2) % 3;
    DynamicList<face> faces;
    for (label i = 0; i < n[a]; ++i)
    for (label j = 0; j < n[b]; ++j)
    {
        face f(4);
        const label di[] = {0, 1, 1, 0}, dj[] = {0, 0, 1, 1};
        for (label c = 0; c < 4; ++c)
        {
            Vector<label> p;
            p[d] = upper ? n[d] : 0;
            p[a] = i + di[c];
            p[b] = j + dj[c];
            f[c] = index(n, p.x(), p.y(), p.z());
        }
        faces.append(upper ? f : f.reverseFace());
    }
    return faceList(std::move(faces));
}

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::Time> Foam::fsbi::testClock()
{
    IStringStream control
    (
        "deltaT 1; writeInterval 1; startTime 0; endTime 1; writeControl timeStep;"
        "runTimeModifiable no;"
    );
    return autoPtr<Time>::New
    (
        dictionary(control), fileName("/tmp"), fileName("fsbiTest"),
        word("system"), word("constant"), false, false
    );
}


Foam::autoPtr<Foam::polyMesh> Foam::fsbi::boxMesh
(
    const Time& clock,
    const boundBox& box,
    const Vector<label>& n,
    const word& sideType,
    const std::function<point(const point&)>& map,
    const bool spot
)
{
    pointField points((n.x() + 1)*(n.y() + 1)*(n.z() + 1));
    cellShapeList cells;
    for (label k = 0; k <= n.z(); ++k)
    for (label j = 0; j <= n.y(); ++j)
    for (label i = 0; i <= n.x(); ++i)
    {
        const vector s(scalar(i)/n.x(), scalar(j)/n.y(), scalar(k)/n.z());
        point& p = points[index(n, i, j, k)];
        p = box.min() + cmptMultiply(s, box.span());
        if (map)
        {
            p = map(p);
        }
        if (i < n.x() && j < n.y() && k < n.z())
        {
            labelList c
            ({
                index(n, i, j, k), index(n, i+1, j, k),
                index(n, i+1, j+1, k), index(n, i, j+1, k),
                index(n, i, j, k+1), index(n, i+1, j, k+1),
                index(n, i+1, j+1, k+1), index(n, i, j+1, k+1)
            });
            cells.append(cellShape(cellModel::ref(cellModel::HEX), c));
        }
    }

    faceListList sides({side(n, 0, false), side(n, 0, true), faceList()});
    for (const direction d : {1, 2})
    {
        sides[2].append(side(n, d, false));
        sides[2].append(side(n, d, true));
    }
    wordList names({"xMin", "xMax", "walls"});
    if (spot)
    {
        DynamicList<face> inside, others;
        for (const face& f : sides[2])
        {
            const point c((f.centre(points) - box.min()));
            const bool in =
                c.z() < 1e-6 && mag(c.x()/box.span().x() - 0.4) < 0.2
             && mag(c.y()/box.span().y() - 0.5) < 0.2;
            (in ? inside : others).append(f);
        }
        sides[2] = others;
        sides.append(inside);
        names.append("spot");
    }
    PtrList<dictionary> dicts(names.size());
    forAll(dicts, i)
    {
        dicts.set(i, new dictionary());
        dicts[i].set("type", i < 2 ? sideType : word("wall"));
        if (i < 2 && sideType == "cyclic")
        {
            dicts[i].set("neighbourPatch", names[1 - i]);
        }
    }
    return autoPtr<polyMesh>::New
    (
        IOobject("background", clock.constant(), clock, IOobject::NO_READ),
        std::move(points), cells, sides, names, dicts, "default", "empty", false
    );
}
