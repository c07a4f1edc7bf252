/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bonds.H"
#include "OStringStream.H"

void Foam::fsbi::bonds::declare(recording& history) const
{
    for (const bondPair& pair : adhesion_->pairs())
    {
        history.declare
        (
            "bonds/" + pair.name,
            {"number", "formed", "broken", "tension", "fx", "fy", "fz"},
            "tension: M L/T^2, f: M L/T^2"
        );
    }
    history.declare
    (
        "bonds/events",
        {
            "instant", "pair", "set", "site", "formed", "length", "tension",
            "ax", "ay", "az", "bx", "by", "bz"
        },
        "instant: T, length: L, tension: M L/T^2, a: L, b: L"
    );
}


void Foam::fsbi::bonds::record(recording& history) const
{
    List<scalarList> sums(adhesion_->pairs().size(), scalarList(7, Zero));
    for (const bondEvent& e : events_)
    {
        sums[e.pair][e.formed ? 1 : 2] += 1;
        history.append
        (
            "bonds/events",
            scalarList
            ({
                e.time, scalar(e.pair), scalar(e.set), scalar(e.site),
                scalar(e.formed), e.length, e.force,
                e.a.x(), e.a.y(), e.a.z(), e.b.x(), e.b.y(), e.b.z()
            })
        );
    }
    const currentSurfaces now(context_);
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        const bondPair& pair = adhesion_->pairs()[b.pair];
        const Pair<point> at(ends(now, entry));
        const vector along(at.second() - at.first());
        const scalar f = pair.law->force(pair.length(at.first(), at.second()));
        const vector force(f*along/max(mag(along), VSMALL));
        scalarList& sum = sums[b.pair];
        sum[0] += 1;
        sum[3] += f;
        for (direction d = 0; d < 3; ++d)
        {
            sum[4 + d] += force[d];
        }
    }
    forAll(sums, i)
    {
        history.append("bonds/" + adhesion_->pairs()[i].name, sums[i]);
    }
}


void Foam::fsbi::bonds::draw
(
    const std::function<void(const fileName&, const std::string&)>& add
) const
{
    const currentSurfaces now(context_);
    const label n = state_.bonds.size();
    OStringStream points, lines, pairs, tensions;
    points.precision(10);
    label i = 0;
    for (const auto& entry : state_.bonds)
    {
        const bond& b = entry.second;
        const bondPair& pair = adhesion_->pairs()[b.pair];
        const Pair<point> at(ends(now, entry));
        for (const point& p : at)
        {
            points << p.x() << ' ' << p.y() << ' ' << p.z() << nl;
        }
        lines << "2 " << 2*i << ' ' << 2*i + 1 << nl;
        pairs << b.pair << nl;
        tensions << pair.law->force(pair.length(at.first(), at.second()))
            << nl;
        ++i;
    }
    OStringStream os;
    os  << "# vtk DataFile Version 3.0\nbonds, from receptor to ligand\nASCII\n"
        << "DATASET POLYDATA\nPOINTS " << 2*n << " double\n"
        << points.str().c_str() << "LINES " << n << ' ' << 3*n << nl
        << lines.str().c_str() << "CELL_DATA " << n
        << "\nSCALARS pair int 1\nLOOKUP_TABLE default\n"
        << pairs.str().c_str()
        << "SCALARS tension double 1\nLOOKUP_TABLE default\n"
        << tensions.str().c_str();
    add("bonds.vtk", os.str());
}
