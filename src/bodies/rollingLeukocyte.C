/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "rollingLeukocyte.H"
#include "leukocyte.H"
#include "OStringStream.H"
#include "Time.H"
#include "Tuple2.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(rollingLeukocyte, 0);
addToRunTimeSelectionTable(body, rollingLeukocyte, entries);

//- Distance from y = 0, in radii, below which a point belongs to both halves
//  of the map: above round-off, below any edge
static const scalar seam = 1e-9;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::rollingLeukocyte::rollingLeukocyte
(
    const word& name,
    const dictionary& dict,
    const scalar time,
    const dictionary& saved
)
:
    prescribedBody(name, dict)
{
    read(saved);
    begin(time, saved);
}


Foam::fsbi::rollingLeukocyte::rollingLeukocyte
(
    const bodySite& site, const dictionary& dict, const dictionary& saved
)
:
    rollingLeukocyte(site.name, dict, site.time.value(), saved)
{}


void Foam::fsbi::rollingLeukocyte::read(const dictionary& saved)
{
    const dictionary& dict = entries_.subDict("shape");
    checkedDictionary(dict).choice("type", {"leukocyte"});
    const leukocyte shape(dict);
    map_.reset(new leukocyteMap(shape.map()));
    const Tuple2<vector, scalar> turned(orientationOf(entries_));
    turned_ = rotationBy
    (
        turned.second()*turned.first()/max(mag(turned.first()), VSMALL)
    );
    OStringStream orientation;
    orientation.precision(17);
    orientation << turned;
    shapeText_ = textOf(dict) + "orientation " + orientation.str();

    if (saved.empty())
    {
        take(shape.triangulate());
        surface_.check(name());
    }
    else if (saved.get<string>("shape") != shapeText_)
    {
        FatalIOErrorInFunction(entries_.dict())
            << "The shape or orientation of body '" << name() << "' is no"
            << " longer the one of the saved state, which is {" << nl
            << saved.get<string>("shape").c_str() << "}. Put it back, or start"
            << " a new run at time 0" << exit(FatalIOError);
    }
}


void Foam::fsbi::rollingLeukocyte::take(const bodySurface& surface)
{
    surface_ = surface;
    sphere_ = surface_.points();
    for (point& p : sphere_)
    {
        p = map_->toSphere(p);
    }
}


Foam::tensor Foam::fsbi::rollingLeukocyte::slope(const point& p) const
{
    const scalar r = radius();
    const vector up(0, seam*r, 0);
    return mag(p.y()) < up.y()
      ? 0.5*(map_->gradient(p + up) + map_->gradient(p - up))
      : map_->gradient(p);
}


Foam::pointField Foam::fsbi::rollingLeukocyte::sphereNow() const
{
    const tensor turned(turned_.R());
    return (turned.T() & now().orientation.R() & turned) & sphere_;
}


Foam::vector Foam::fsbi::rollingLeukocyte::mapped(const point& p) const
{
    const vector omega(turned_.invTransform(angular(now().velocity)));
    return turned_.transform(slope(p) & (omega ^ p));
}


Foam::vector Foam::fsbi::rollingLeukocyte::velocityAt(const point& x) const
{
    const vector V(linear(now().velocity));
    if (angular(now().velocity) == vector(Zero))
    {
        return V;
    }
    // centres of faces lie a little below the exact surface
    const point p(map_->toSphere(turned_.invTransform(x - now().centre)));
    return V + mapped(radius()/mag(p)*p);
}


Foam::fsbi::bodySurface Foam::fsbi::rollingLeukocyte::placedSurface() const
{
    pointField x(sphereNow());
    for (point& p : x)
    {
        p = placed().transform(map_->fromSphere(p));
    }
    return bodySurface(x, surface_.triangles());
}


Foam::vectorField Foam::fsbi::rollingLeukocyte::pointVelocity() const
{
    vectorField v(sphereNow());
    for (vector& p : v)
    {
        p = linear(now().velocity) + mapped(p);
    }
    return v;
}


Foam::fsbi::bodySurface Foam::fsbi::rollingLeukocyte::surfaceForMesh() const
{
    return surface_.transformed(turned_.R(), now().centre);
}


void Foam::fsbi::rollingLeukocyte::save(dictionary& state) const
{
    prescribedBody::save(state);
    state.set("shape", shapeText_);
    state.set("points", surface_.points());
    state.set("triangles", surface_.triangles());
}


void Foam::fsbi::rollingLeukocyte::restore(const dictionary& state)
{
    prescribedBody::restore(state);
    take
    (
        bodySurface
        (
            state.get<pointField>("points"),
            state.get<List<triFace>>("triangles")
        )
    );
}
