/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "partVertices.H"
#include "syncTools.H"
#include <functional>

Foam::fsbi::partVertices::partVertices
(
    const fvMesh& mesh, const label nHalo, const labelUList& parts
)
:
    mesh_(mesh),
    nHalo_(nHalo),
    parts_(parts)
{
    if (returnReduce(parts_.size(), sumOp<label>()))
    {
        setNumbers();
    }
}


void Foam::fsbi::partVertices::setNumbers()
{
    lowest_ = labelList(mesh_.nPoints(), labelMax);
    labelList highest(mesh_.nPoints(), -1);
    const auto visit = [&](const std::function<void(label, label)>& see)
    {
        forAll(mesh_.cellPoints(), celli)
        {
            for (const label v : mesh_.cellPoints()[celli])
            {
                see(v, parts_[celli]);
            }
        }
    };
    visit
    (
        [&](const label v, const label part)
        {
            lowest_[v] = min(lowest_[v], part);
            highest[v] = max(highest[v], part);
        }
    );
    syncTools::syncPointList(mesh_, lowest_, minEqOp<label>(), labelMax);
    syncTools::syncPointList(mesh_, highest, maxEqOp<label>(), label(-1));
    visit
    (
        [&](const label v, const label part)
        {
            if (part != lowest_[v] && part != highest[v])
            {
                FatalErrorInFunction
                    << "Three parts of body '" << mesh_.name() << "' meet at "
                    << mesh_.points()[v] << ", two may: move them apart"
                    << exit(FatalError);
            }
        }
    );
    second_ = labelList(mesh_.nPoints(), -1);
    DynamicList<label> behind, highestBehind;
    forAll(second_, v)
    {
        if (highest[v] > lowest_[v])
        {
            second_[v] = mesh_.nPoints() + behind.size();
            behind.append(v);
            highestBehind.append(highest[v]);
        }
    }
    behind_.transfer(behind);
    highest_.transfer(highestBehind);
    ofCells_ = mesh_.cellPoints();
    forAll(ofCells_, celli)
    {
        for (label& v : ofCells_[celli])
        {
            v = of(parts_[celli], v);
        }
    }
}
