/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfacesTogether.H"
#include "triangleCrossings.H"
#include "OStringStream.H"

void Foam::fsbi::surfacesTogether::append
(
    const bodySurface& surface, const word& name, const string& meets
)
{
    for (const triFace& t : surface.triangles())
    {
        const label n = points_.size();
        triangles_.append(triFace(t[0] + n, t[1] + n, t[2] + n));
        group_.append(names_.size());
    }
    points_.append(surface.points());
    names_.append(name);
    meets_.append(meets);
}


Foam::string Foam::fsbi::surfacesTogether::crossing(const label walls) const
{
    const labelPair two
    (
        triangleCrossing(points_, triangles_, group_, walls)
    );
    if (two.first() < 0)
    {
        return string();
    }
    const label a = min(group_[two.first()], group_[two.second()]);
    const label b = max(group_[two.first()], group_[two.second()]);
    // of an image of a body at a wall it is the image that crosses
    const bool imageAtWall = a == walls;
    OStringStream reason;
    reason
        << "Body '" << names_[imageAtWall ? b : a] << "' "
        << meets_[imageAtWall ? a : b].c_str() << " near "
        << triangles_[two.first()].centre(points_);
    return reason.str();
}
