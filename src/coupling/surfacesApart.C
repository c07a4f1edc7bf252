/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "surfacesApart.H"
#include "ways.H"

Foam::fsbi::surfacesApart::surfacesApart
(
    effectList& effects,
    UPtrList<rigidBody>& rigid,
    UPtrList<solidRegion>& solids,
    const std::function<List<bodyRows>()>& rowsNow
)
:
    effects_(effects),
    rigid_(rigid),
    solids_(solids),
    rowsNow_(rowsNow)
{}


Foam::fsbi::surfacesApart::state Foam::fsbi::surfacesApart::now() const
{
    state s;
    for (const rigidBody& body : rigid_)
    {
        s.rigid.append(body.placed());
    }
    for (solidRegion& solid : solids_)
    {
        s.surfaces.append(solid.surface().displacement());
        s.unknowns.append(*solid.rows().x);
    }
    return s;
}


void Foam::fsbi::surfacesApart::place(const state& s)
{
    forAll(rigid_, b)
    {
        rigid_[b].stand(s.rigid[b]);
    }
    forAll(solids_, e)
    {
        solids_[e].surface().place(s.surfaces[e]);
    }
}


void Foam::fsbi::surfacesApart::follow()
{
    for (solidRegion& solid : solids_)
    {
        solid.follow();
    }
}


bool Foam::fsbi::surfacesApart::touching() const
{
    return effects_.stopped().found(true);
}


std::function<void(const Foam::scalar)> Foam::fsbi::surfacesApart::wayBetween
(
    const state& from, const state& to, const UList<sixVector>& ways
)
{
    const List<sixVector> along(ways);
    return [=](const scalar part)
    {
        state s(to);
        forAll(s.rigid, b)
        {
            s.rigid[b] = placement
            {
                from.rigid[b].centre + part*linear(along[b]),
                rotationBy(part*angular(along[b]))*from.rigid[b].orientation
            };
        }
        for (label e = 0; part < 1 && e < s.surfaces.size(); ++e)
        {
            s.surfaces[e] =
                from.surfaces[e] + part*(to.surfaces[e] - from.surfaces[e]);
        }
        place(s);
    };
}


bool Foam::fsbi::surfacesApart::hold(List<bodyRows>& rows)
{
    const state guess(now());
    List<sixVector> ways(rigid_.size());
    forAll(ways, b)
    {
        const placement before(rigid_[b].before());
        const placement& there = guess.rigid[b];
        ways[b] = join
        (
            there.centre - before.centre,
            angleOf(there.orientation*conjugate(before.orientation))
        );
        rigid_[b].stand(before);
    }
    for (solidRegion& solid : solids_)
    {
        solid.forget();
    }
    follow();
    start_ = now();
    if (touching() || effects_.clearPart(wayBetween(start_, guess, ways)) < 1)
    {
        place(start_);
        rows = rowsNow_();
        return true;
    }
    place(guess);
    if (touching())
    {
        place(start_);
        rows = rowsNow_();
        return true;
    }
    forAll(solids_, e)
    {
        *solids_[e].rows().x = guess.unknowns[e];
    }
    follow();
    rows = rowsNow_();
    return false;
}


bool Foam::fsbi::surfacesApart::limit
(
    const loads& acting, const scalar most, List<bodyRows>& rows
)
{
    follow();
    const state to(now());
    loads::ofBodies u(acting.atRest());
    List<sixVector> ways(rigid_.size());
    forAll(rigid_, b)
    {
        ways[b] = wayOf(rows[b]);
        u.whole[b] = ways[b];
    }
    forAll(solids_, e)
    {
        vectorField& moved = u.points[rigid_.size() + e];
        moved = to.surfaces[e] - from_.surfaces[e];
        moved.resize(solids_[e].rows().solid.nPoints);  // points are first
    }
    const auto place = wayBetween(from_, to, ways);
    const scalar clear = min(effects_.clearPart(place), most);
    if (clear == 1 && !touching() && !acting.onCorners())
    {
        // rigid bodies go on to where the step's end takes them
        state back(to);
        back.rigid = from_.rigid;
        this->place(back);
        return false;
    }
    const scalar tangent =
        acting.work(acting.forces(), u) + acting.work(acting.changes(u), u);
    const auto force = [&](const scalar part)
    {
        place(part);
        const loads there(effects_.evaluate());
        return there.work(there.forces(), u) - tangent;
    };
    const scalar part = lowest(force, clear);
    place(part);
    take(part, to, rows);
    return true;
}


void Foam::fsbi::surfacesApart::take
(
    const scalar part, const state& to, List<bodyRows>& rows
)
{
    forAll(solids_, e)
    {
        scalarField& x = *solids_[e].rows().x;
        x = to.unknowns[e];
        for (label i = 0; part < 1 && i < x.size(); ++i)
        {
            const scalar from = from_.unknowns[e][i];
            x[i] = from + part*(x[i] - from);
        }
    }
    follow();
    rows = rowsNow_();
    forAll(rows, b)
    {
        // the mesh is where the step began
        rows[b].centre = start_.rigid[b].centre + rigid_[b].toImage();
        forAll(rows[b].velocity, k)
        {
            if (rows[b].free[k])
            {
                rows[b].velocity[k] = rows[b].offset[k]/rows[b].gain;
            }
        }
    }
}


void Foam::fsbi::surfacesApart::atStart(const std::function<void()>& act)
{
    const state here(now());
    place(start_);
    act();
    place(here);
}
