/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexMembers.H"
#include "noTurn.H"
#include "syncTools.H"

namespace Foam
{
namespace fsbi
{

struct joinLists
{
    void operator()(labelList& a, const labelList& b) const
    {
        for (const label i : b)
        {
            if (!a.found(i))
            {
                a.append(i);
            }
        }
    }
};

} // End namespace fsbi
} // End namespace Foam


Foam::fsbi::vertexMembers::vertexMembers(const fvMesh& mesh, const label n)
:
    mesh_(mesh),
    number_(n)
{}


void Foam::fsbi::vertexMembers::setTouching()
{
    syncTools::syncPointList
    (
        mesh_, global_, joinLists(), labelList(), noTurn()
    );
    nTouching_.setSize(global_.size());
    forAll(global_, v)
    {
        sort(global_[v]);
        nTouching_[v] = global_[v].size();
    }
    setMap();
}


void Foam::fsbi::vertexMembers::setMap()
{
    local_ = global_;
    if (UPstream::parRun())
    {
        List<Map<label>> compact;
        map_.reset(new mapDistribute(number_, local_, compact));
    }
}


void Foam::fsbi::vertexMembers::append
(
    const label v, DynamicList<label>& more
)
{
    sort(more);
    label n = 0;
    forAll(more, i)
    {
        if ((i == 0 || more[i] != more[i - 1]) && !global_[v].found(more[i]))
        {
            more[n++] = more[i];
        }
    }
    more.setSize(n);
    global_[v].append(more);
}
