/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    The kernels with the flags of all of fsbiFoam (etc/wmake/options).

\*---------------------------------------------------------------------------*/

#include "tensorField.H"
#include "symmTensorField.H"

#define KERNELS shipped
#include "kernels.H"
