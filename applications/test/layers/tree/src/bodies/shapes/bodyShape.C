/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bodyShape.H"

namespace Foam
{
namespace fsbi
{
    defineTypeNameAndDebug(bodyShape, 0);
    defineRunTimeSelectionTable(bodyShape, dictionary);
}
}

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsbi::bodyShape::bodyShape(const dictionary& dict)
:
    size_(0),
    maxTriangles_(200000),
    entries_(dict)
{
    entries_.found("type");
    size_ = entries_.found("size") ? entries_.positive("size") : 0;
    if (entries_.found("maxTriangles"))
    {
        maxTriangles_ = entries_.positive("maxTriangles");
    }
}


Foam::autoPtr<Foam::fsbi::bodyShape> Foam::fsbi::bodyShape::New
(
    const dictionary& dict
)
{
    const word type(dict.get<word>("type"));
    auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown shape '" << type << "'; valid shapes are "
            << flatOutput(dictionaryConstructorTablePtr_->sortedToc())
            << exit(FatalIOError);
    }
    return constructor()(dict);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::fsbi::bodySurface Foam::fsbi::bodyShape::fineEnough
(
    bodySurface&& surface
) const
{
    if (surface.triangles().size() < fewestTriangles)
    {
        FatalIOErrorInFunction(entries_.dict())
            << "The shape has only " << surface.triangles().size()
            << " triangles, a body needs " << label(fewestTriangles)
            << " or more: choose a smaller 'size'" << exit(FatalIOError);
    }
    return std::move(surface);
}


void Foam::fsbi::bodyShape::checkNumber
(
    const scalar area, const scalar size
) const
{
    const scalar triangles = area/(Foam::sqrt(scalar(3))/4*sqr(size));
    if (triangles > maxTriangles_)
    {
        FatalIOErrorInFunction(entries_.dict())
            << "Edges of " << size << " need about " << triangles
            << " triangles for this shape, more than maxTriangles "
            << maxTriangles_ << ": choose a larger 'size', or raise"
            << " maxTriangles if you have the memory" << exit(FatalIOError);
    }
}


Foam::fsbi::bodySurface Foam::fsbi::bodyShape::triangulate
(
    const scalar size
) const
{
    if (size > 0 || size_ > 0)
    {
        return fineEnough(make(size > 0 ? size : size_));
    }
    return fineEnough(make(entries_.getOrDefault("size", defaultSize())));
}
