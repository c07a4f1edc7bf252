/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "coupledPreconditioner.H"

namespace Foam
{
namespace fsbi
{

defineTypeNameAndDebug(coupledPreconditioner, 0);
defineRunTimeSelectionTable(coupledPreconditioner, coupledSystem);

} // End namespace fsbi
} // End namespace Foam


Foam::autoPtr<Foam::fsbi::coupledPreconditioner>
Foam::fsbi::coupledPreconditioner::New
(
    const word& type, const coupledSystem& system
)
{
    return coupledSystemConstructorTablePtr_->cfind(type)()(system);
}


Foam::wordList Foam::fsbi::coupledPreconditioner::types()
{
    return coupledSystemConstructorTablePtr_->sortedToc();
}
