/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "haloExchange.H"
#include "cyclicPolyPatch.H"
#include "processorPolyPatch.H"
#include "UIPstream.H"
#include "UOPstream.H"

Foam::fsbi::haloExchange::haloExchange(const fvMesh& mesh)
:
    mesh_(mesh),
    size_(0)
{
    for (const polyPatch& pp : mesh.boundaryMesh())
    {
        if (!pp.coupled())
        {
            continue;
        }
        if (!isA<processorPolyPatch>(pp) && !isA<cyclicPolyPatch>(pp))
        {
            FatalErrorInFunction
                << "Patch '" << pp.name() << "' is of type " << pp.type()
                << "; coupled patches may be cyclic or processor"
                << exit(FatalError);
        }
        patches_.append(pp.index());
        starts_.append(size_);
        size_ += pp.size();
    }
    send_.setSize(patches_.size());
}


void Foam::fsbi::haloExchange::fill(scalar* values, const label width) const
{
    const label firstRequest = UPstream::nRequests();
    const std::streamsize bytes = width*sizeof(scalar);

    forAll(patches_, i)
    {
        const polyPatch& pp = mesh_.boundaryMesh()[patches_[i]];
        const bool remote = isA<processorPolyPatch>(pp);
        const label source =
            remote
          ? patches_[i]
          : refCast<const cyclicPolyPatch>(pp).neighbPatchID();

        const labelUList& cells = mesh_.boundaryMesh()[source].faceCells();
        scalar* halo = values + width*(mesh_.nCells() + starts_[i]);

        scalar* out = halo;
        if (remote)
        {
            send_[i].setSize(width*pp.size());
            out = send_[i].data();
        }
        for (const label celli : cells)
        {
            out = std::copy_n(values + width*celli, width, out);
        }
        if (remote)
        {
            const label other =
                refCast<const processorPolyPatch>(pp).neighbProcNo();
            UIPstream::read
            (
                UPstream::commsTypes::nonBlocking, other,
                reinterpret_cast<char*>(halo), bytes*pp.size()
            );
            UOPstream::write
            (
                UPstream::commsTypes::nonBlocking, other,
                reinterpret_cast<const char*>(send_[i].cdata()),
                bytes*pp.size()
            );
        }
    }
    UPstream::waitRequests(firstRequest);
}
