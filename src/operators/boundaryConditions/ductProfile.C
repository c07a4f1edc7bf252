/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "ductProfile.H"

#include <Eigen/SparseCholesky>
#include <map>
#include <utility>

namespace Foam
{
namespace fsbi
{

typedef std::pair<scalar, scalar> coordinates;

static coordinates of(const vector2D& x)
{
    return {x.x(), x.y()};
}

static scalar cross(const vector2D& a, const vector2D& b)
{
    return a.x()*b.y() - a.y()*b.x();
}

//- Gradients of the six quadratic shapes where the corners have these parts
static FixedList<vector2D, 6> gradients
(
    const FixedList<scalar, 3>& parts, const FixedList<vector2D, 3>& slopes
)
{
    FixedList<vector2D, 6> g;
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1) % 3, k = (i + 2) % 3;
        g[i] = (4*parts[i] - 1)*slopes[i];
        g[3 + i] = 4*(parts[j]*slopes[k] + parts[k]*slopes[j]);
    }
    return g;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::ductProfile::ductProfile(const UList<triangle>& triangles)
:
    flow_(0)
{
    number(triangles);
    solve();
    sort();
}


void Foam::fsbi::ductProfile::number(const UList<triangle>& triangles)
{
    std::map<coordinates, label> numbers;
    std::map<std::pair<label, label>, std::pair<label, label>> edges;
    DynamicList<vector2D> nodes;
    elements_.setSize(triangles.size());
    forAll(triangles, t)
    {
        for (label i = 0; i < 3; ++i)
        {
            const vector2D& x = triangles[t][i];
            const auto found = numbers.insert({of(x), nodes.size()});
            if (found.second)
            {
                nodes.append(x);
            }
            elements_[t][i] = found.first->second;
        }
    }
    // of each edge the node in its middle, and how many triangles have it
    for (element& e : elements_)
    {
        for (label i = 0; i < 3; ++i)
        {
            const label a = e[(i + 1) % 3], b = e[(i + 2) % 3];
            const auto found = edges.insert
            (
                {{min(a, b), max(a, b)}, {nodes.size(), 0}}
            );
            if (found.second)
            {
                nodes.append(0.5*(nodes[a] + nodes[b]));
            }
            e[3 + i] = found.first->second.first;
            ++found.first->second.second;
        }
    }
    nodes_.transfer(nodes);
    inside_.setSize(nodes_.size(), true);
    for (const auto& edge : edges)
    {
        if (edge.second.second == 1)
        {
            inside_[edge.first.first] = false;
            inside_[edge.first.second] = false;
            inside_[edge.second.first] = false;
        }
    }
}


void Foam::fsbi::ductProfile::solve()
{
    labelList unknown(nodes_.size(), -1);
    label n = 0;
    forAll(inside_, i)
    {
        unknown[i] = inside_[i] ? n++ : -1;
    }
    std::vector<Eigen::Triplet<scalar>> entries;
    Eigen::VectorXd load(Eigen::VectorXd::Zero(n));
    for (const element& e : elements_)
    {
        const vector2D a(nodes_[e[1]] - nodes_[e[0]]);
        const vector2D b(nodes_[e[2]] - nodes_[e[0]]);
        const scalar twice = cross(a, b);
        FixedList<vector2D, 3> slopes;
        slopes[1] = vector2D(b.y(), -b.x())/twice;
        slopes[2] = vector2D(-a.y(), a.x())/twice;
        slopes[0] = -slopes[1] - slopes[2];
        const scalar weight = mag(twice)/6;
        // the rule of the edges' middles is exact here
        for (label q = 0; q < 3; ++q)
        {
            FixedList<scalar, 3> parts(scalar(0.5));
            parts[q] = 0;
            const FixedList<vector2D, 6> g(gradients(parts, slopes));
            for (label i = 0; i < 6; ++i)
            {
                for (label j = 0; j < 6; ++j)
                {
                    const label row = unknown[e[i]], column = unknown[e[j]];
                    if (row >= 0 && column >= 0)
                    {
                        entries.emplace_back(row, column, weight*(g[i] & g[j]));
                    }
                }
            }
            if (unknown[e[3 + q]] >= 0)
            {
                load[unknown[e[3 + q]]] += weight;
            }
        }
    }
    Eigen::SparseMatrix<scalar> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<scalar>> factors(matrix);
    const Eigen::VectorXd solution(factors.solve(load));
    w_.setSize(nodes_.size(), Zero);
    forAll(w_, i)
    {
        w_[i] = inside_[i] ? solution[unknown[i]] : 0;
    }
    flow_ = n ? load.dot(solution) : 0;
}


void Foam::fsbi::ductProfile::sort()
{
    vector2D top(-GREAT, -GREAT);
    corner_ = -top;
    for (const vector2D& x : nodes_)
    {
        corner_ = min(corner_, x);
        top = max(top, x);
    }
    across_ = 1 + label(Foam::sqrt(scalar(elements_.size())));
    pitch_ = max(max(top.x() - corner_.x(), top.y() - corner_.y()), VSMALL)
       /across_;
    near_.setSize(across_*across_);
    forAll(elements_, t)
    {
        FixedList<label, 2> low(across_), high(label(0));
        for (label i = 0; i < 3; ++i)
        {
            for (direction d = 0; d < 2; ++d)
            {
                const label s = squareOf(nodes_[elements_[t][i]][d], d);
                low[d] = min(low[d], s);
                high[d] = max(high[d], s);
            }
        }
        for (label i = low[0]; i <= high[0]; ++i)
        {
            for (label j = low[1]; j <= high[1]; ++j)
            {
                near_[i*across_ + j].append(t);
            }
        }
    }
}


Foam::label Foam::fsbi::ductProfile::squareOf
(
    const scalar x, const direction d
) const
{
    const label s = (x - corner_[d])/pitch_;
    return max(label(0), min(s, across_ - 1));
}


Foam::FixedList<Foam::scalar, 3> Foam::fsbi::ductProfile::parts
(
    const label t, const vector2D& x
) const
{
    const element& e = elements_[t];
    const vector2D a(nodes_[e[1]] - nodes_[e[0]]);
    const vector2D b(nodes_[e[2]] - nodes_[e[0]]);
    const vector2D r(x - nodes_[e[0]]);
    const scalar twice = cross(a, b);
    const scalar u = cross(r, b)/twice, v = cross(a, r)/twice;
    FixedList<scalar, 3> result;
    result[0] = 1 - u - v;
    result[1] = u;
    result[2] = v;
    return result;
}


Foam::scalar Foam::fsbi::ductProfile::operator()(const vector2D& x) const
{
    // the triangle that the point is farthest inside of, or least outside
    scalar best = -GREAT;
    label found = -1;
    FixedList<scalar, 3> at(scalar(0));
    const auto look = [&](const label t)
    {
        const FixedList<scalar, 3> p(parts(t, x));
        const scalar least = min(p[0], min(p[1], p[2]));
        if (least > best)
        {
            best = least;
            found = t;
            at = p;
        }
    };
    for (const label t : near_[squareOf(x.x(), 0)*across_ + squareOf(x.y(), 1)])
    {
        look(t);
    }
    for (label t = 0; found < 0 && t < elements_.size(); ++t)
    {
        look(t);
    }
    scalar w = 0;
    for (label i = 0; i < 3; ++i)
    {
        const element& e = elements_[found];
        w += at[i]*(2*at[i] - 1)*w_[e[i]]
          + 4*at[(i + 1) % 3]*at[(i + 2) % 3]*w_[e[3 + i]];
    }
    return w;
}
