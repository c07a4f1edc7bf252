/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "meshOverlap.H"
#include "globalIndex.H"
#include "ofAllProcessors.H"
#include "pointSearch.H"

namespace Foam
{
namespace fsbi
{

//- Boxes of a leaf, at most
static const label leafSize = 8;

//- Part of a cell's volume that may stay without an old cell: round-off
static const scalar roundOff = 1e-9;

static scalar volumeOf(const FixedList<point, 4>& t)
{
    return mag(((t[1] - t[0]) ^ (t[2] - t[0])) & (t[3] - t[0]))/6;
}

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::boxTree::boxTree(const List<treeBoundBox>& boxes)
:
    boxes_(boxes),
    order_(identity(boxes.size()))
{
    if (boxes.size())
    {
        divide(0, boxes.size());
    }
}


Foam::label Foam::fsbi::boxTree::divide(const label first, const label last)
{
    const label me = nodes_.size();
    node n{boxes_[order_[first]], first, last, -1, -1};
    for (label i = first + 1; i < last; ++i)
    {
        n.box.add(boxes_[order_[i]]);
    }
    nodes_.append(n);
    if (last - first <= leafSize)
    {
        return me;
    }
    const vector span(n.box.span());
    direction d = 0;
    for (direction k = 1; k < 3; ++k)
    {
        d = span[k] > span[d] ? k : d;
    }
    const label middle = (first + last)/2;
    std::nth_element
    (
        order_.begin() + first, order_.begin() + middle, order_.begin() + last,
        [&](const label a, const label b)
        {
            const scalar xa = boxes_[a].min()[d] + boxes_[a].max()[d];
            const scalar xb = boxes_[b].min()[d] + boxes_[b].max()[d];
            return xa < xb || (xa == xb && a < b);
        }
    );
    const label left = divide(first, middle);
    const label right = divide(middle, last);
    nodes_[me].left = left;
    nodes_[me].right = right;
    return me;
}


void Foam::fsbi::boxTree::find
(
    const treeBoundBox& box, DynamicList<label>& found
) const
{
    found.clear();
    DynamicList<label> open;
    if (nodes_.size())
    {
        open.append(0);
    }
    while (open.size())
    {
        const node& n = nodes_[open.remove()];
        if (!n.box.overlaps(box))
        {
            continue;
        }
        if (n.left >= 0)
        {
            open.append(n.right);
            open.append(n.left);
            continue;
        }
        for (label i = n.first; i < n.last; ++i)
        {
            if (boxes_[order_[i]].overlaps(box))
            {
                found.append(order_[i]);
            }
        }
    }
}


void Foam::fsbi::meshOverlap::divide
(
    const fvMesh& mesh,
    const pointField& points,
    pointField& corners,
    labelList& cells
)
{
    DynamicList<point> x;
    DynamicList<label> of;
    const auto add = [&](const point& a, const face& f, const label celli)
    {
        for (label k = 1; k + 1 < f.size(); ++k)
        {
            x.append(a);
            x.append(points[f[0]]);
            x.append(points[f[k]]);
            x.append(points[f[k + 1]]);
            of.append(celli);
        }
    };
    forAll(mesh.cells(), celli)
    {
        const cell& c = mesh.cells()[celli];
        const labelList vertices(c.labels(mesh.faces()));
        if (vertices.size() == 4)
        {
            // one face and the vertex that is not on it
            const face& f = mesh.faces()[c[0]];
            for (const label v : vertices)
            {
                if (!f.found(v))
                {
                    add(points[v], f, celli);
                }
            }
            continue;
        }
        point middle(Zero);
        for (const label v : vertices)
        {
            middle += points[v]/vertices.size();
        }
        for (const label facei : c)
        {
            add(middle, mesh.faces()[facei], celli);
        }
    }
    corners.transfer(x);
    cells.transfer(of);
}


Foam::treeBoundBox Foam::fsbi::meshOverlap::boxOf
(
    const pointField& corners, const label t
)
{
    return treeBoundBox(SubList<point>(corners, 4, 4*t));
}


Foam::fsbi::meshOverlap::meshOverlap
(
    const fvMesh& mesh,
    const pointField& points,
    const vectorField& u,
    const tensorField& gradient
)
{
    divide(mesh, points, corners_, cells_);
    scalarField volumes(mesh.nCells(), Zero);
    centres_ = pointField(mesh.nCells(), Zero);
    forAll(cells_, t)
    {
        corners c;
        std::copy_n(corners_.cbegin() + 4*t, 4, c.begin());
        const scalar V = volumeOf(c);
        volumes[cells_[t]] += V;
        centres_[cells_[t]] += V/4*(c[0] + c[1] + c[2] + c[3]);
    }
    centres_ /= volumes;

    // numbers of the cells in the lists of all
    const globalIndex numbers(mesh.nCells());
    for (label& celli : cells_)
    {
        celli = numbers.toGlobal(celli);
    }
    centres_ = ofAllProcessors(centres_);
    u_ = ofAllProcessors(u);
    gradients_ = ofAllProcessors(gradient);
    corners_ = ofAllProcessors(corners_);
    cells_ = ofAllProcessors(cells_);
}


void Foam::fsbi::meshOverlap::addOverlap
(
    const corners& t,
    const FixedList<point, 4>& onPlane,
    const FixedList<vector, 4>& normal,
    const label k,
    scalar& volume,
    vector& moment
)
{
    if (k == 4)
    {
        const scalar V = volumeOf(t);
        volume += V;
        moment += V/4*(t[0] + t[1] + t[2] + t[3]);
        return;
    }
    // corners behind the plane first
    corners x;
    scalar d[4];
    label inside = 0, outside = 4;
    for (const point& p : t)
    {
        const scalar distance = (p - onPlane[k]) & normal[k];
        const label i = distance <= 0 ? inside++ : --outside;
        x[i] = p;
        d[i] = distance;
    }
    const auto cut = [&](const label in, const label out)
    {
        return point(x[in] + d[in]/(d[in] - d[out])*(x[out] - x[in]));
    };
    const auto next = [&](const corners& part)
    {
        addOverlap(part, onPlane, normal, k + 1, volume, moment);
    };
    if (inside == 4)
    {
        next(x);
    }
    else if (inside == 1)
    {
        next(corners({x[0], cut(0, 1), cut(0, 2), cut(0, 3)}));
    }
    else if (inside > 1)
    {
        // a prism
        const FixedList<point, 3> a
        (
            inside == 3
          ? FixedList<point, 3>({x[0], x[1], x[2]})
          : FixedList<point, 3>({x[0], cut(0, 2), cut(0, 3)})
        );
        const FixedList<point, 3> b
        (
            inside == 3
          ? FixedList<point, 3>({cut(0, 3), cut(1, 3), cut(2, 3)})
          : FixedList<point, 3>({x[1], cut(1, 2), cut(1, 3)})
        );
        next(corners({a[0], a[1], a[2], b[0]}));
        next(corners({a[1], a[2], b[0], b[1]}));
        next(corners({a[2], b[0], b[1], b[2]}));
    }
}


void Foam::fsbi::meshOverlap::moveBy(const vector& way)
{
    corners_ += way;
    centres_ += way;
}


void Foam::fsbi::meshOverlap::onto
(
    const fvMesh& mesh, vectorField& u, tensorField& gradient
) const
{
    List<treeBoundBox> boxes(cells_.size());
    forAll(boxes, t)
    {
        boxes[t] = boxOf(corners_, t);
    }
    const boxTree tree(boxes);
    pointField parts;
    labelList of;
    divide(mesh, mesh.points(), parts, of);

    u = vectorField(mesh.nCells(), Zero);
    gradient = tensorField(mesh.nCells(), Zero);
    scalarField covered(mesh.nCells(), Zero);
    DynamicList<label> found;
    forAll(of, t)
    {
        const point* x = parts.cdata() + 4*t;
        const point middle((x[0] + x[1] + x[2] + x[3])/4);
        FixedList<point, 4> onPlane;
        FixedList<vector, 4> normal;
        for (label k = 0; k < 4; ++k)
        {
            const point& a = x[(k + 1) % 4];
            const vector n((x[(k + 2) % 4] - a) ^ (x[(k + 3) % 4] - a));
            onPlane[k] = a;
            normal[k] = ((middle - a) & n) > 0 ? vector(-n) : n;
        }
        tree.find(boxOf(parts, t), found);
        for (const label o : found)
        {
            corners c;
            std::copy_n(corners_.cbegin() + 4*o, 4, c.begin());
            scalar V = 0;
            vector moment(Zero);
            addOverlap(c, onPlane, normal, 0, V, moment);
            const label from = cells_[o];
            covered[of[t]] += V;
            u[of[t]] +=
                V*u_[from] + ((moment - V*centres_[from]) & gradients_[from]);
            gradient[of[t]] += V*gradients_[from];
        }
    }
    fillGaps(mesh, covered, u, gradient);
}


void Foam::fsbi::meshOverlap::fillGaps
(
    const fvMesh& mesh,
    const scalarField& covered,
    vectorField& u,
    tensorField& gradient
) const
{
    const pointSearch centres(centres_);
    const scalarField& V = mesh.cellVolumes();
    forAll(V, celli)
    {
        const scalar open = V[celli] - covered[celli];
        if (open < roundOff*V[celli])
        {
            u[celli] /= covered[celli];
            gradient[celli] /= covered[celli];
            continue;
        }
        const point& x = mesh.cellCentres()[celli];
        const label from = centres.nearest(x);
        u[celli] +=
            open*(u_[from] + ((x - centres_[from]) & gradients_[from]));
        gradient[celli] += open*gradients_[from];
        u[celli] /= V[celli];
        gradient[celli] /= V[celli];
    }
}
