/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "volumeMesher.H"
#include "loadLibraries.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(volumeMesher, 0);
defineRunTimeSelectionTable(volumeMesher, entries);

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::volumeMesher> Foam::fsbi::volumeMesher::New
(
    const scalar diameter
)
{
    loadLibraryOf("gmsh");
    if (!entriesConstructorTablePtr_)
    {
        FatalErrorInFunction
            << "The library libfsbiGmsh.so, which meshes, cannot be loaded."
            << " Is gmsh's library there? Run Allwmake again"
            << exit(FatalError);
    }
    return (*entriesConstructorTablePtr_)["gmsh"](diameter);
}
