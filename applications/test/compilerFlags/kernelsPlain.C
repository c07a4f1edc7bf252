/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    The kernels at -O1, without vectorisation.

\*---------------------------------------------------------------------------*/

#pragma GCC optimize ("O1", "no-tree-vectorize", "no-tree-slp-vectorize")

#include "tensorField.H"
#include "symmTensorField.H"

#define KERNELS plain
#include "kernels.H"
