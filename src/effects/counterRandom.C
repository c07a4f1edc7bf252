/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "counterRandom.H"

// Here only: it reads a hundred headers of processors' instructions
#include <Random123/philox.h>

uint32_t Foam::fsbi::counterRandom::hash(const std::string& name)
{
    uint32_t h = 2166136261u;
    for (const unsigned char c : name)
    {
        h = (h ^ c)*16777619u;
    }
    return h;
}


Foam::fsbi::counterRandom::words Foam::fsbi::counterRandom::philox
(
    const words& counter,
    const key& k
)
{
    const r123::Philox4x32::ctr_type drawn = r123::Philox4x32()
    (
        {{counter[0], counter[1], counter[2], counter[3]}},
        {{k[0], k[1]}}
    );
    return {{drawn[0], drawn[1], drawn[2], drawn[3]}};
}


Foam::scalar Foam::fsbi::counterRandom::stream::uniform()
{
    const label first = half_ ? 2 : 0;
    if (!half_)
    {
        words_ = philox(counter_, key_);
        ++counter_[2];
    }
    half_ = !half_;
    const scalar high = words_[first] >> 5;
    const scalar low = words_[first + 1] >> 6;
    return (high*67108864.0 + low + 1)/9007199254740992.0;
}
