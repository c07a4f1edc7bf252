/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "loads.H"
#include <cmath>

Foam::fsbi::loads::loads(const List<List<triFace>>& triangles)
:
    triangles_(triangles),
    nPoints_(triangles.size(), Zero),
    force_(triangles.size(), sixVector(scalar(0))),
    stiffness_(triangles.size(), sixMatrix(sixVector(scalar(0))))
{}


void Foam::fsbi::loads::countPoints(const site& s)
{
    if (s.body < 0 || !s.onCorners || nPoints_[s.body])
    {
        return;
    }
    for (const triFace& f : triangles_[s.body])
    {
        for (const label v : f)
        {
            nPoints_[s.body] = max(nPoints_[s.body], v + 1);
        }
    }
}


void Foam::fsbi::loads::add(const spring& s)
{
    springs_.append(s);
    countPoints(s.a);
    countPoints(s.b);
}


void Foam::fsbi::loads::add
(
    const label bodyi, const sixVector& force, const sixMatrix& stiffness
)
{
    forAll(force, k)
    {
        force_[bodyi][k] += force[k];
        forAll(force, m)
        {
            stiffness_[bodyi][k][m] += stiffness[k][m];
        }
    }
}


bool Foam::fsbi::loads::finite() const
{
    scalar sum = 0;
    for (const sixVector& f : force_)
    {
        for (const scalar component : f)
        {
            sum += component;
        }
    }
    for (const spring& s : springs_)
    {
        sum += cmptSum(s.force);
    }
    return std::isfinite(sum);
}


Foam::scalar Foam::fsbi::loads::gross() const
{
    scalar sum = 0;
    for (const spring& s : springs_)
    {
        sum += mag(s.force);
    }
    return sum;
}


bool Foam::fsbi::loads::empty() const
{
    for (const sixVector& force : force_)
    {
        if (force != sixVector(scalar(0)))
        {
            return false;
        }
    }
    // a load may be zero and yet answer to displacements
    forAll(stiffness_, b)
    {
        if (stiff(b))
        {
            return false;
        }
    }
    return springs_.empty();
}


bool Foam::fsbi::loads::stiff(const label bodyi) const
{
    for (const sixVector& row : stiffness_[bodyi])
    {
        for (const scalar s : row)
        {
            if (s != 0)
            {
                return true;
            }
        }
    }
    for (const spring& s : springs_)
    {
        if
        (
            (s.a.body == bodyi || s.b.body == bodyi) && magSqr(s.stiffness) > 0
        )
        {
            return true;
        }
    }
    return false;
}


Foam::fsbi::loads Foam::fsbi::loads::others() const
{
    loads result(*this);
    result.springs_.clear();
    for (const spring& s : springs_)
    {
        if (!onCorners(s))
        {
            result.springs_.append(s);
        }
    }
    return result;
}


bool Foam::fsbi::loads::onElastic() const
{
    const auto elastic = [this](const site& s)
    {
        return s.body >= 0 && triangles_[s.body].size();
    };
    for (const spring& s : springs_)
    {
        if (elastic(s.a) || elastic(s.b))
        {
            return true;
        }
    }
    return false;
}


Foam::fsbi::loads::onBodies Foam::fsbi::loads::zero() const
{
    onBodies result;
    result.whole.setSize(triangles_.size(), sixVector(scalar(0)));
    result.triangles.setSize(triangles_.size());
    result.points.setSize(triangles_.size());
    forAll(triangles_, b)
    {
        result.triangles[b] = vectorField(triangles_[b].size(), Zero);
        result.points[b] = vectorField(nPoints_[b], Zero);
    }
    return result;
}


Foam::fsbi::loads::ofBodies Foam::fsbi::loads::atRest() const
{
    ofBodies result;
    result.whole.setSize(triangles_.size(), sixVector(scalar(0)));
    result.points.setSize(triangles_.size());
    return result;
}


Foam::vector Foam::fsbi::loads::displacement
(
    const site& s, const ofBodies& u
) const
{
    if (s.body < 0)
    {
        return Zero;
    }
    if (triangles_[s.body].empty())
    {
        const sixVector& whole = u.whole[s.body];
        return linear(whole) + (angular(whole) ^ s.arm);
    }
    const vectorField& points = u.points[s.body];
    if (points.empty())
    {
        return Zero;
    }
    const triFace& f = triangles_[s.body][s.triangle];
    return
        s.weights.x()*points[f[0]]
      + s.weights.y()*points[f[1]]
      + s.weights.z()*points[f[2]];
}


void Foam::fsbi::loads::pull
(
    const site& s, const vector& force, onBodies& sum
) const
{
    if (s.body < 0)
    {
        return;
    }
    if (triangles_[s.body].size() && s.onCorners)
    {
        const triFace& f = triangles_[s.body][s.triangle];
        forAll(f, k)
        {
            sum.points[s.body][f[k]] += s.weights[k]*force;
        }
        return;
    }
    if (triangles_[s.body].size())
    {
        sum.triangles[s.body][s.triangle] += force;
        return;
    }
    const sixVector add(join(force, s.arm ^ force));
    forAll(add, k)
    {
        sum.whole[s.body][k] += add[k];
    }
}


Foam::fsbi::loads::onBodies Foam::fsbi::loads::forces() const
{
    onBodies sum(zero());
    sum.whole = force_;
    for (const spring& s : springs_)
    {
        pull(s.a, s.force, sum);
        pull(s.b, -s.force, sum);
    }
    return sum;
}


Foam::fsbi::loads::onBodies Foam::fsbi::loads::changes
(
    const ofBodies& u
) const
{
    onBodies sum(zero());
    forAll(stiffness_, b)
    {
        forAll(stiffness_[b], k)
        {
            forAll(stiffness_[b][k], m)
            {
                sum.whole[b][k] -= stiffness_[b][k][m]*u.whole[b][m];
            }
        }
    }
    for (const spring& s : springs_)
    {
        const vector force
        (
           -(s.stiffness & (displacement(s.a, u) - displacement(s.b, u)))
        );
        pull(s.a, force, sum);
        pull(s.b, -force, sum);
    }
    return sum;
}


Foam::scalar Foam::fsbi::loads::work
(
    const onBodies& f, const ofBodies& u
) const
{
    scalar sum = 0;
    forAll(triangles_, b)
    {
        forAll(f.whole[b], k)
        {
            sum += f.whole[b][k]*u.whole[b][k];
        }
        forAll(f.points[b], i)
        {
            sum += f.points[b][i] & u.points[b][i];
        }
        if (u.points[b].size())
        {
            forAll(f.triangles[b], i)
            {
                const triFace& t = triangles_[b][i];
                const vectorField& d = u.points[b];
                sum += (f.triangles[b][i] & (d[t[0]] + d[t[1]] + d[t[2]]))/3;
            }
        }
    }
    return sum;
}


Foam::tensorField Foam::fsbi::loads::springStiffness(const label bodyi) const
{
    tensorField sum(triangles_[bodyi].size(), Zero);
    for (const spring& s : springs_)
    {
        for (const site* end : {&s.a, &s.b})
        {
            if (end->body == bodyi && !onCorners(s))
            {
                sum[end->triangle] += s.stiffness;
            }
        }
    }
    return sum;
}
