/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceData.H"
#include "surfaceTransfer.H"
#include "rigidFit.H"
#include "volFields.H"
#include "IFstream.H"
#include "OFstream.H"
#include "IOField.H"

#include <sstream>

namespace Foam
{
namespace fsbi
{

static const string header("x,y,z,ux,uy,uz,tx,ty,tz");

//- Of tractions on a deformed surface, as fsbiResistance writes them
static const string tractionHeader("x,y,z,tx,ty,tz");

//- How far the nearest point may be, over the distance of those that the plane of
//  a traction is fitted to
static const scalar farthest = 2;

//- Below this a surface is not one
static const label fewest = 10;

//- Numbers of a line; false if it has more or less
static bool numbers(const string& line, scalarList& row)
{
    std::istringstream is(line);
    std::string word;
    label n = 0;
    while (std::getline(is, word, ','))
    {
        char* end = nullptr;
        const scalar value = std::strtod(word.c_str(), &end);
        if (n == row.size() || end == word.c_str() || *end > ' ')
        {
            return false;
        }
        row[n++] = value;
    }
    return n == row.size();
}

//- All of it finite, but a traction may be left open as a whole
static bool sound(const scalarList& row)
{
    label open = 0;
    forAll(row, i)
    {
        if (!std::isfinite(row[i]))
        {
            ++open;
            if (i < 6)
            {
                return false;
            }
        }
    }
    return open == 0 || (open == 3 && row.size() == 9);
}


//- Rows of a file with this header; fatal with the line where it is not one
static List<scalarList> readRows
(
    const fileName& file, const string& columns, const label n
)
{
    IFstream is(file);
    if (!is.good())
    {
        FatalErrorInFunction
            << "There is no file " << file << " with data of the surface"
            << exit(FatalError);
    }
    string line;
    is.getLine(line);
    if (line != columns)
    {
        FatalErrorInFunction
            << file << " must begin with the line " << columns.c_str()
            << ", but begins with '" << line.c_str() << "'"
            << exit(FatalError);
    }
    DynamicList<scalarList> rows;
    for (label number = 2; is.good(); ++number)
    {
        scalarList row(n);
        if (!is.getLine(line).good() && line.empty())
        {
            break;
        }
        if (!numbers(line, row) || !sound(row))
        {
            FatalErrorInFunction
                << file << ", line " << number << ", is '" << line.c_str()
                << "', but must be " << (n == 9 ? "nine" : "six")
                << " numbers with commas between them"
                << (n == 9 ? "; of these the three of the traction may be nan" : "")
                << exit(FatalError);
        }
        rows.append(row);
    }
    if (rows.size() < fewest)
    {
        FatalErrorInFunction
            << file << " has " << rows.size() << " points; a surface needs "
            << fewest << " at least" << exit(FatalError);
    }
    return List<scalarList>(std::move(rows));
}


static vector at(const scalarList& row, const label i)
{
    return vector(row[i], row[i + 1], row[i + 2]);
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::surfaceData Foam::fsbi::surfaceData::read(const fileName& file)
{
    const List<scalarList> rows(readRows(file, header, 9));
    surfaceData data
    {
        pointField(rows.size()), vectorField(rows.size()),
        vectorField(rows.size())
    };
    forAll(rows, i)
    {
        data.x[i] = at(rows[i], 0);
        data.u[i] = at(rows[i], 3);
        data.t[i] = at(rows[i], 6);
    }
    return data;
}


void Foam::fsbi::surfaceData::readTractions(const fileName& file)
{
    const List<scalarList> rows(readRows(file, tractionHeader, 6));
    pointField points(rows.size());
    forAll(rows, i)
    {
        points[i] = at(rows[i], 0);
    }
    forAll(x, i)
    {
        const point now(x[i] + u[i]);
        const labelList near
        (
            surfaceTransfer::nearest
            (
                points, now, surfaceTransfer::planePoints
            )
        );
        const point& closest = points[near[0]];
        if (mag(closest - now) > farthest*mag(points[near.last()] - closest))
        {
            FatalErrorInFunction
                << file << " has no traction near the observed point " << now
                << "; the nearest is at " << closest << ". It has to be that of"
                << " the deformed surface, in the same place"
                << exit(FatalError);
        }
        const scalarList weights
        (
            surfaceTransfer::fit(points, near, now, false)
        );
        const bool known = loaded(i);
        t[i] = known ? Zero : t[i];
        for (label j = 0; known && j < near.size(); ++j)
        {
            t[i] += weights[j]*at(rows[near[j]], 3);
        }
    }
}


Foam::fsbi::surfaceData Foam::fsbi::surfaceData::saved(const fvMesh& mesh)
{
    const auto stored = [&](const word& name, const fileName& folder)
    {
        return IOobject
        (
            name, mesh.time().timeName(), folder, mesh,
            IOobject::MUST_READ, IOobject::NO_WRITE, false
        );
    };
    const volVectorField D(stored("D", ""), mesh);
    const IOField<vector> force(stored("faceForce", "state"));
    DynamicList<vector> x, u, t;
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        forAll(pp, i)
        {
            const label facei = pp.start() + i;
            x.append(mesh.faceCentres()[facei]);
            u.append(D.boundaryField()[pp.index()][i]);
            t.append
            (
                force[facei - mesh.nInternalFaces()]
               /mag(mesh.faceAreas()[facei])
            );
        }
    }
    return {pointField(x), vectorField(u), vectorField(t)};
}


void Foam::fsbi::surfaceData::write(const fileName& file) const
{
    OFstream os(file);
    os.precision(12);
    os << header.c_str() << nl;
    forAll(x, i)
    {
        label n = 0;
        for (const vector& v : {x[i], u[i], t[i]})
        {
            for (direction k = 0; k < 3; ++k)
            {
                os << (n++ ? "," : "") << v[k];
            }
        }
        os << nl;
    }
}


void Foam::fsbi::surfaceData::turnBack()
{
    const rigidFit fit(x, scalarField(x.size(), 1));
    const placement now(fit(x + u));
    const quaternion back(inv(now.orientation));
    const point centre(average(x));
    forAll(x, i)
    {
        u[i] = back.transform(x[i] + u[i] - now.centre) + centre - x[i];
        t[i] = back.transform(t[i]);
    }
}
