/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "redGreen.H"

Foam::fsbi::redGreen::redGreen
(
    const pointField& points,
    const UList<triFace>& triangles,
    const std::function<point(const point&)>& project
)
:
    project_(project),
    points_(points),
    triangles_(triangles),
    origins_(identity(triangles.size()))
{
    forAll(points, p)
    {
        parents_.append(edge(p, p));
    }
}


Foam::label Foam::fsbi::redGreen::middle(const label a, const label b)
{
    label& m = middle_(edge(a, b), -1);
    if (m < 0)
    {
        m = points_.size();
        points_.append(project_(0.5*(points_[a] + points_[b])));
        parents_.append(edge(a, b));
    }
    return m;
}


bool Foam::fsbi::redGreen::crowded(const triFace& t) const
{
    label n = 0;
    for (label i = 0; i < 3; ++i)
    {
        const label a = t[i], b = t[(i + 1) % 3];
        const label m = found(a, b);
        if (m >= 0)
        {
            ++n;
            if (found(a, m) >= 0 || found(m, b) >= 0)
            {
                return true;
            }
        }
    }
    return n > 1;
}


void Foam::fsbi::redGreen::cut(const label trianglei)
{
    const triFace t(triangles_[trianglei]);
    const label ab = middle(t[0], t[1]);
    const label bc = middle(t[1], t[2]);
    const label ca = middle(t[2], t[0]);
    triangles_[trianglei] = triFace(ab, bc, ca);
    triangles_.append(triFace(t[0], ab, ca));
    triangles_.append(triFace(ab, t[1], bc));
    triangles_.append(triFace(ca, bc, t[2]));
    for (label part = 0; part < 3; ++part)
    {
        origins_.append(label(origins_[trianglei]));
    }
}


void Foam::fsbi::redGreen::split(const UList<bool>& marked)
{
    forAll(marked, i)
    {
        if (marked[i])
        {
            cut(i);
        }
    }
    for (bool again = true; again; )
    {
        again = false;
        const label n = triangles_.size();
        for (label i = 0; i < n; ++i)
        {
            if (crowded(triangles_[i]))
            {
                cut(i);
                again = true;
            }
        }
    }
}


Foam::List<Foam::triFace> Foam::fsbi::redGreen::conforming
(
    labelList* origins
) const
{
    DynamicList<triFace> result(triangles_.size());
    DynamicList<label> from(triangles_.size());
    forAll(triangles_, trianglei)
    {
        const triFace& t = triangles_[trianglei];
        from.append(origins_[trianglei]);
        label side = -1, m = -1;
        for (label i = 0; i < 3 && m < 0; ++i)
        {
            side = i;
            m = found(t[i], t[(i + 1) % 3]);
        }
        if (m < 0)
        {
            result.append(t);
            continue;
        }
        const label a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
        result.append(triFace(a, m, c));
        result.append(triFace(m, b, c));
        from.append(origins_[trianglei]);
    }
    if (origins)
    {
        origins->transfer(from);
    }
    return List<triFace>(std::move(result));
}
