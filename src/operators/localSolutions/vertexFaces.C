/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "vertexFaces.H"

Foam::fsbi::vertexFaces::vertexFaces
(
    const fvMesh& mesh, const labelList& faces
)
:
    vertexMembers(mesh, faces.size()),
    faces_(faces)
{
    global_ = labelListList(mesh.nPoints());
    forAll(faces, i)
    {
        for (const label v : mesh.faces()[faces[i]])
        {
            global_[v].append(number_.toGlobal(i));
        }
    }
    setTouching();
}


void Foam::fsbi::vertexFaces::widen
(
    const boolList& vertices, const vertexCells& cells
)
{
    labelListList ofCell(mesh_.nCells());
    forAll(faces_, i)
    {
        ofCell[mesh_.faceOwner()[faces_[i]]].append(number_.toGlobal(i));
    }
    cells.fill(ofCell);
    forAll(vertices, v)
    {
        if (vertices[v])
        {
            DynamicList<label> more;
            for (const label celli : cells[v])
            {
                more.append(ofCell[celli]);
            }
            append(v, more);
        }
    }
    setMap();
}
