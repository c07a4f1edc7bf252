/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "magnetics.H"
#include "boundBox.H"
#include "OStringStream.H"

namespace
{

//- Points along each axis
const Foam::label gridPoints = 15;

//- Room around every body, in its half diagonals
const Foam::scalar gridMargin = 3;

} // End anonymous namespace


void Foam::fsbi::magnetics::draw
(
    const std::function<void(const fileName&, const std::string&)>& add
) const
{
    boundBox box;
    for (const immersedBody& b : context_.bodies)
    {
        const bodySurface surface(b.atImage(b.placedSurface()));
        const boundBox body(surface.points(), false);
        const vector margin(gridMargin*0.5*body.mag()*vector::one);
        box.add(body.min() - margin);
        box.add(body.max() + margin);
    }
    const vector step(box.span()/(gridPoints - 1));
    const scalar t = context_.time.value();

    OStringStream os;
    os.precision(6);
    os  << "# vtk DataFile Version 3.0\nmagnetic field (T) of all but the"
        << " bodies\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS";
    const auto triple = [&](const vector& v)
    {
        os << ' ' << v.x() << ' ' << v.y() << ' ' << v.z() << nl;
    };
    triple(gridPoints*vector::one);
    os << "ORIGIN";
    triple(box.min());
    os << "SPACING";
    triple(step);
    os << "POINT_DATA " << gridPoints*gridPoints*gridPoints << "\nVECTORS B double\n";
    for (label k = 0; k < gridPoints; ++k)
    {
        for (label j = 0; j < gridPoints; ++j)
        {
            for (label i = 0; i < gridPoints; ++i)
            {
                const vector ijk(i, j, k);
                triple(givenB(box.min() + cmptMultiply(step, ijk), t));
            }
        }
    }
    add("B.vtk", os.str());
}
