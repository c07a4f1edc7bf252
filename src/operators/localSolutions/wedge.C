/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "wedge.H"
#include <algorithm>

namespace Foam
{
namespace fsbi
{

//- Least J, far inside of a narrow arc
static const scalar leastJacobian = 0.3;

//- Relative difference of squared distances that may be round-off
static const scalar alike = 1e-6;

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::wedge::wedge
(
    const point& v, const sharpVertex& s, const point& x
)
:
    origin_(v),
    curvature_(s.curvature),
    lengths_(s.lengths),
    angle_(s.angle)
{
    const vector bisector(-normalised(s.normals[0] + s.normals[1]));
    axes_ = tensor(bisector, s.tangent ^ bisector, s.tangent);
    point foot;
    tensor axes;
    moveTo(x, foot, axes);
    distance_ = magSqr(x - foot);
}


bool Foam::fsbi::wedge::nearer(const wedge& w) const
{
    if (mag(distance_ - w.distance_) > alike*min(distance_, w.distance_))
    {
        return distance_ < w.distance_;
    }
    return
        std::lexicographical_compare
        (
            origin_.cdata(), origin_.cdata() + 3,
            w.origin_.cdata(), w.origin_.cdata() + 3
        );
}


Foam::FixedList<Foam::scalar, 2> Foam::fsbi::wedge::sagitta
(
    const scalar along
) const
{
    const scalar L = lengths_[along < 0 ? 0 : 1];
    const scalar s = mag(along) - L*std::floor(mag(along)/L);
    const scalar slope = 0.5*mag(curvature_)*(L - 2*s);
    return FixedList<scalar, 2>
    ({
        0.5*mag(curvature_)*s*(L - s), along < 0 ? -slope : slope
    });
}


Foam::scalar Foam::fsbi::wedge::moveTo
(
    const point& x, point& origin, tensor& axes
) const
{
    const vector t(axes_.z());
    const vector d(x - origin_);
    const scalar kappa = mag(curvature_);
    origin = origin_ + (d & t)*t;
    axes = axes_;
    if (kappa*mag(d) < 1e-6)
    {
        return d & t;
    }
    // about the axis of the arc
    const vector inwards(curvature_/kappa);
    const scalar angle = std::atan2(d & t, 1/kappa - (d & inwards));
    const scalar c = Foam::cos(angle), s = Foam::sin(angle);
    origin = origin_ + (s*t + (1 - c)*inwards)/kappa;
    const vector axis(t ^ inwards);
    const tensor turn
    (
        c*tensor::I + (1 - c)*axis*axis + s*(inwards*t - t*inwards)
    );
    axes = axes_ & turn.T();
    return angle/kappa;
}


Foam::FixedList<Foam::fsbi::wedgeModes::flow, Foam::fsbi::wedgeModes::n>
Foam::fsbi::wedge::flowsAt
(
    const point& x, const wedgeModes& modes, const scalar perLength
) const
{
    point origin;
    tensor axes;
    const auto inside(sagitta(moveTo(x, origin, axes)));
    const vector d(perLength*(axes & (x - origin)));
    const vector kappa((axes_ & curvature_)/perLength);
    const vector inwards(kappa/max(mag(kappa), VSMALL));
    const scalar g = 1/max(1 - (kappa & d), leastJacobian);
    FixedList<wedgeModes::flow, wedgeModes::n> result
    (
        modes.at(d - perLength*inside[0]*inwards)
    );
    for (wedgeModes::flow& flow : result)
    {
        const vector u(g*flow.u.x(), g*flow.u.y(), flow.u.z());
        const vector z(0, 0, 1);
        tensor gradient(flow.gradient & tensor(g, 0, 0, 0, g, 0, 0, 0, 1));
        // along the arc the chord goes inwards and the axes turn
        const vector along
        (
            u.z()*kappa - (u & kappa)*z - inside[1]*(inwards & gradient)
        );
        gradient += g*(kappa*vector(u.x(), u.y(), 0) + z*along);
        flow.u = axes.T() & u;
        flow.p *= perLength;
        flow.gradient = perLength*(axes.T() & gradient & axes);
    }
    return result;
}
