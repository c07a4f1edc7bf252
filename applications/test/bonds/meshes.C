/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "bondChecks.H"
#include "bonds.H"
#include "caps.H"

namespace Foam
{
namespace fsbi
{

static const scalar half = 0.6, density = 3000;


//- Numbers of bonds in equilibrium over some seeds, as a row of a table
static void row
(
    const std::string& sites, const std::string& correction,
    const bool onePerFace, const label cells, const label seeds
)
{
    testScene scene(2*half/cells, 0.045, half);
    scene.addSphere(2*half/cells, point::max, half);
    // about one bond, so that nearly all molecules are free
    const scalar k0on =
        correction == "none" ? 1e-7 : onePerFace ? 2e-10 : 5e-11;
    const scalar receptors = onePerFace ? 2*sqr(cells/(2*half)) : density;
    scalar sum = 0, squares = 0;
    for (label seed = 1; seed <= seeds; ++seed)
    {
        char what[400];
        snprintf
        (
            what, sizeof(what), "molecules { cap { A { density %.9g; } }"
            " ball { B { density %.9g; } } } pairs { pair { kinds (A B);"
            " law Dembo; lambda 0.05; s 0.2; sts 0.2; k0on %g; k0off 1e-3;"
            " sites %s; faceCorrection %s; } }", receptors, density, k0on,
            sites.c_str(), correction.c_str()
        );
        scene.restartClock();
        autoPtr<bonds> b(scene.make(what, seed));
        scene.begin(b(), 1e4);
        sum += b->all().size()/scalar(seeds);
        squares += sqr(scalar(b->all().size()))/seeds;
    }
    printf
    (
        "%s %s %d %d %.9g %.9g\n", sites.c_str(), correction.c_str(),
        int(onePerFace), cells, sum, sqrt((squares - sqr(sum))/(seeds - 1))
    );
    fflush(stdout);
}


void numbersByMesh(const label finest, const label seeds)
{
    printf("# sites correction onePerFace cells bonds deviation\n");
    for (label cells = 6; cells <= finest; cells *= 2)
    {
        // on coarse meshes they cost less
        const label all = seeds*max(24/cells, 1);
        for (const std::string sites : {"molecules", "faces"})
        for (const std::string correction : {"none", "global", "conserving"})
        {
            row(sites, correction, false, cells, all);
        }
        // few receptors have few bonds
        row("faces", "global", true, cells, all*max(24/cells, 1));
    }
}

} // End namespace fsbi
} // End namespace Foam
