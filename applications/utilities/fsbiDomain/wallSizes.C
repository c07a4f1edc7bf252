/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wallSizes.H"

namespace Foam
{
namespace fsbi
{

//- Increase of the size with the distance from a finer box
static const scalar growth = 0.3;

static const scalar mostTriangles = 1e6;

static scalar areaOf(const vector& span)
{
    return
        2*(span.x()*span.y() + span.y()*span.z() + span.z()*span.x());
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::wallSizes::wallSizes(const checkedDictionary& entries)
:
    size_(entries.positive("size"))
{
    const dictionary& boxes = entries.subDictOrEmpty("finer");
    for (const entry& e : boxes)
    {
        if (!e.isDict())
        {
            FatalIOErrorInFunction(boxes)
                << "Entry '" << e.keyword() << "' of finer must be a box"
                << " { min (x y z); max (x y z); size ...; }"
                << exit(FatalIOError);
        }
        const checkedDictionary dict(e.dict());
        const boundBox bounds(dict.get<point>("min"), dict.get<point>("max"));
        const scalar size = dict.positive("size");
        dict.finish();
        if (cmptMin(bounds.span()) <= 0)
        {
            FatalIOErrorInFunction(e.dict())
                << "Entry 'max' " << bounds.max() << " must be above 'min' "
                << bounds.min() << " in all three directions"
                << exit(FatalIOError);
        }
        if (size >= size_)
        {
            FatalIOErrorInFunction(e.dict())
                << "Entry 'size' " << size << " is not below that of all walls, "
                << size_ << exit(FatalIOError);
        }
        finer_.append({e.keyword(), bounds, size, &e.dict()});
    }
}


Foam::scalar Foam::fsbi::wallSizes::operator()(const point& x) const
{
    scalar size = size_;
    for (const box& b : finer_)
    {
        const point nearest(max(min(x, b.bounds.max()), b.bounds.min()));
        size = min(size, b.size + growth*mag(x - nearest));
    }
    return size;
}


void Foam::fsbi::wallSizes::checkCount
(
    const dictionary& dict,
    const scalar size,
    const boundBox& within,
    const scalar area
) const
{
    const vector span(within.span());
    const scalar n = area/(0.433*sqr(size));
    if (size > 0.5*cmptMin(span) || n > mostTriangles)
    {
        FatalIOErrorInFunction(dict)
            << "Edges of size " << size << " do not suit a domain of "
            << span.x() << " by " << span.y() << " by " << span.z() << ": "
            << (n > mostTriangles
              ? "its walls would have " + name(label(min(n, 1e9))) + " triangles"
              : string("the longest that fit are half of its shortest side")).c_str()
            << ". Is it in another unit (scale)?" << exit(FatalIOError);
    }
}


void Foam::fsbi::wallSizes::check
(
    const dictionary& dict, const bodySurface& domain
) const
{
    const boundBox bounds(domain.bounds());
    checkCount(dict, size_, bounds, domain.area());
    for (const box& b : finer_)
    {
        const boundBox within
        (
            max(b.bounds.min(), bounds.min()), min(b.bounds.max(), bounds.max())
        );
        if (cmptMin(within.span()) < 0)
        {
            FatalIOErrorInFunction(*b.dict)
                << "The box '" << b.name << "' of finer, from " << b.bounds.min()
                << " to " << b.bounds.max() << ", is outside of the domain, from "
                << bounds.min() << " to " << bounds.max() << exit(FatalIOError);
        }
        checkCount
        (
            *b.dict, b.size, bounds, min(domain.area(), areaOf(within.span()))
        );
    }
}
