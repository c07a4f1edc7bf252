/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// How near bodies and walls are, and what to say of it

#include "fluidMesh.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "wallPolyPatch.H"

namespace Foam
{
namespace fsbi
{

//- Part of a gap that may close before triangles are cut anew
static const scalar closing = 0.5;

//- Gap proposed for contact, in radii of the smallest body: what triangles are cut
//  for is a tenth of it
static const scalar proposedGap = 0.005;

//- With two digits
static scalar rounded(const scalar x)
{
    const scalar unit = pow(scalar(10), std::floor(log10(x)) - 1);
    return unit*std::round(x/unit);
}

} // End namespace fsbi
} // End namespace Foam


Foam::scalar Foam::fsbi::fluidMesh::finestEdge() const
{
    scalar edge = GREAT;
    for (const immersedBody& body : present_)
    {
        edge = min(edge, body.meshedSurface().meanEdge());
    }
    return edge;
}


bool Foam::fsbi::fluidMesh::refines() const
{
    bool all = remeshControls(remeshDict_).gapSag > 0;
    for (const immersedBody& body : present_)
    {
        all = all && body.mayBeCut();
    }
    return all;
}


Foam::scalar Foam::fsbi::fluidMesh::resolvedGap(const bool cut) const
{
    if (cut)
    {
        return narrowestGap(finestEdge());
    }
    const remeshControls controls(remeshDict_);
    return
        controls.cellsPerGap
       *(
            controls.minSize > 0
          ? controls.minSize
          : remeshControls::finestPart*finestEdge()
        );
}


Foam::string Foam::fsbi::fluidMesh::unresolved(const scalar gap) const
{
    if (gap >= resolvedGap(false))
    {
        return string();
    }
    const bool atWall = smallestGap(walls_) <= gap;
    const bool cut = refines() && atWall;
    if (gap >= resolvedGap(cut))
    {
        return string();
    }
    const bool whole = std::any_of
    (
        present_.begin(), present_.end(), [](const immersedBody& body)
        {
            return body.deforms() && !body.mayBeCut();
        }
    );
    return
        "A gap of " + Foam::name(gap) + " is narrower than the "
      + Foam::name(resolvedGap(cut))
      + (
            cut
          ? " that triangles are cut for"
          : " that have cellsPerGap cells of minSize across"
        )
      + ": the flow in it is not resolved (system/remeshDict; shape size in"
        " constant/bodies"
      + (
            atWall
          ? ")"
          : "; it is at a patch that is not of type wall in"
            " system/blockMeshDict, where no triangle is cut)"
        )
      + (
            whole
          ? ". Of elastic bodies triangles are cut for it by order 2 with the"
            " scheme monolithic"
          : ""
        );
}


Foam::string Foam::fsbi::fluidMesh::closingGap() const
{
    if (!refines())
    {
        return string();
    }
    const scalar gap = smallestGap(walls_);
    return
        gap < closing*referenceGap_ && gap < finestEdge()
      ? "a gap has closed from " + Foam::name(referenceGap_) + " to "
      + Foam::name(gap)
      : string();
}


Foam::string Foam::fsbi::fluidMesh::keptApart() const
{
    scalar radius = GREAT;
    for (const immersedBody& body : present_)
    {
        radius = min(radius, body.radius());
    }
    return
        "in constant/effects `contact { gap "
      + Foam::name(rounded(proposedGap*radius)) + "; pressure P; }`, on which"
        " bodies rest (P some 5 F/(pi R gap) for a load F on a radius R),"
        " or 'repulsion'";
}


Foam::string Foam::fsbi::fluidMesh::narrowGap(const bool apart) const
{
    // at the start nothing could have kept them apart
    const scalar gap = smallestGap();
    if (apart ? unresolved(gap).empty() : !mesh_)
    {
        return string();
    }
    const string leaving(bodyThatLeaves(gap));
    if (leaving.size())
    {
        return leaving;
    }
    return
        apart
      ? " (bodies and walls are as near as " + Foam::name(gap)
      + ": that needs a smaller 'size' of the shapes in constant/bodies, or an"
        " effect that keeps them apart: " + keptApart() + ")"
      : " (what may not meet is kept apart by an effect: " + keptApart() + ")";
}


Foam::string Foam::fsbi::fluidMesh::bodyThatLeaves(const scalar gap) const
{
    if (!mesh_)
    {
        return string();
    }
    const vector moved(shift() - referenceShift_);
    for (const polyPatch& patch : mesh().boundaryMesh())
    {
        if
        (
            isA<processorPolyPatch>(patch) || isA<wallPolyPatch>(patch)
         || isBody(patch.name())
         || (images_.size() && isA<cyclicPolyPatch>(patch))
        )
        {
            continue;
        }
        const triangleTree* surface = patchTree(patch.name());
        for (const immersedBody& body : present_)
        {
            const bodySurface meshed(body.meshedSurface());
            for (const point& p : meshed.points())
            {
                scalar distance;
                if
                (
                    surface
                 && surface->find(p - moved, 1.01*gap + SMALL, distance)
                )
                {
                    return
                        " (body '" + body.name() + "' has come to the patch '"
                      + patch.name() + "', which "
                      + (
                            isA<cyclicPolyPatch>(patch) && confined_.size()
                          ? "it may not cross, as " + confined_ + ")"
                          : string
                            (
                                "is no wall, but cannot leave there, as no fluid"
                                " does: make the domain longer in"
                                " system/blockMeshDict, or let it follow the body"
                                " with `follow` in system/remeshDict)"
                            )
                        );
                }
            }
        }
    }
    return string();
}


Foam::List<Foam::fsbi::bodySurface> Foam::fsbi::fluidMesh::cutSurfaces() const
{
    List<bodySurface> cut(bodies_.size());
    label present = 0;
    forAll(cut, b)
    {
        if (bodyPatch(b) < 0)
        {
            continue;
        }
        if (!bodies_[b].deforms() && motion_ && motion_->refined(present))
        {
            cut[b] = motion_->surface(present);
        }
        ++present;
    }
    return cut;
}


const Foam::fsbi::surfaceCut& Foam::fsbi::fluidMesh::cut
(
    const label bodyi
) const
{
    static const surfaceCut none;
    label present = 0;
    for (label b = 0; b < bodyi; ++b)
    {
        present += bodyPatch(b) >= 0;
    }
    return bodyPatch(bodyi) < 0 ? none : motion_->cut(present);
}


Foam::scalar Foam::fsbi::fluidMesh::smallestGap() const
{
    return smallestGap(boundary_);
}


Foam::scalar Foam::fsbi::fluidMesh::smallestGap
(
    const autoPtr<triangleTree>& walls
) const
{
    const vector moved(shift() - referenceShift_);
    scalar gap = GREAT;
    const auto now = [&](const label b)
    {
        return motion_ ? motion_->surface(b) : present_[b].meshedSurface();
    };
    const auto approach =
        [&](const triangleTree& surface, const pointField& x, const vector& by)
        {
            for (const point& p : x)
            {
                scalar distance;
                if (surface.find(p - by, gap, distance))
                {
                    gap = min(gap, distance);
                }
            }
        };
    forAll(present_, b)
    {
        const bodySurface surface(now(b));
        if (walls)          // known with the first mesh
        {
            approach(walls(), surface.points(), moved);
            for (const vector& image : images_)
            {
                approach(walls(), surface.points(), moved + image);
            }
        }
        if (present_.size() == 1 && images_.empty())
        {
            continue;
        }
        const triangleTree tree(surface);
        for (label other = 0; other < b; ++other)
        {
            approach(tree, now(other).points(), Zero);
        }
        for (const vector& image : images_)
        {
            for (label other = 0; other <= b; ++other)
            {
                approach(tree, now(other).points(), image);
            }
        }
    }
    return gap;
}


Foam::fsbi::outcome Foam::fsbi::fluidMesh::holdsBodies()
{
    if (withoutBodies_)
    {
        return outcome();
    }
    auto timer = timings_.measure("meshing");
    string reason;
    if (Pstream::master())
    {
        readDomain();
        const wordList names(namesOf(present_));
        const bodySurface walls
        (
            boundary_->surface().transformed
            (
                tensor::I, shift() - referenceShift_
            )
        );
        const auto inside = [&](const UList<surfaceInGaps>& bodies)
        {
            reason = mesher_->inside
            (
                names, surfacesOf(bodies), walls, shift()
            ).reason;
            return reason.empty();
        };
        // a new mesh has triangles that are cut for the gaps there now, or not
        if (!inside(motion_->surfaces()) && refines())
        {
            const List<surfaceInGaps> cut(refinedSurfaces(true));
            if (!inside(cut) && anyCut(cut))
            {
                inside(refinedSurfaces(false));
            }
        }
    }
    Pstream::scatter(reason);
    return
        reason.empty()
      ? outcome()
      : outcome::failed
        (
            "where the step ends there is no mesh: " + reason
          + narrowGap(false)
        );
}
