/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfaceData.H"
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

//- Below this a surface is not one
static const label fewest = 10;

//- Nine numbers of a line; false if it has others
static bool numbers(const string& line, FixedList<scalar, 9>& row)
{
    std::istringstream is(line);
    std::string word;
    label n = 0;
    while (std::getline(is, word, ','))
    {
        char* end = nullptr;
        const scalar value = std::strtod(word.c_str(), &end);
        if (n == 9 || end == word.c_str() || *end > ' ')
        {
            return false;
        }
        row[n++] = value;
    }
    return n == 9;
}

//- All of it finite, but a traction may be left open as a whole
static bool sound(const FixedList<scalar, 9>& row)
{
    label open = 0;
    for (label i = 0; i < 9; ++i)
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
    return open == 0 || open == 3;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::surfaceData Foam::fsbi::surfaceData::read(const fileName& file)
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
    if (line != header)
    {
        FatalErrorInFunction
            << file << " must begin with the line " << header.c_str()
            << ", but begins with '" << line.c_str() << "'"
            << exit(FatalError);
    }
    DynamicList<vector> x, u, t;
    for (label number = 2; is.good(); ++number)
    {
        FixedList<scalar, 9> row;
        if (!is.getLine(line).good() && line.empty())
        {
            break;
        }
        if (!numbers(line, row) || !sound(row))
        {
            FatalErrorInFunction
                << file << ", line " << number << ", is '" << line.c_str()
                << "', but must be nine numbers with commas between them; of"
                << " these the three of the traction may be nan"
                << exit(FatalError);
        }
        x.append(vector(row[0], row[1], row[2]));
        u.append(vector(row[3], row[4], row[5]));
        t.append(vector(row[6], row[7], row[8]));
    }
    if (x.size() < fewest)
    {
        FatalErrorInFunction
            << file << " has " << x.size() << " points; a surface needs "
            << fewest << " at least" << exit(FatalError);
    }
    return {pointField(x), vectorField(u), vectorField(t)};
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
