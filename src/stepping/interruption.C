/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "interruption.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"
#include <csignal>
#include <unistd.h>

namespace
{

volatile std::sig_atomic_t interrupted = 0;
volatile std::sig_atomic_t speaker = 0;

extern "C" void onInterrupt(int signal)
{
    static const char message[] =
        "\nThe run ends after this step, with a saved state;"
        " once more ends it at once\n";
    interrupted = 1;
    std::signal(signal, SIG_DFL);
    if (speaker && write(STDERR_FILENO, message, sizeof(message) - 1) < 0)
    {
        speaker = 0;
    }
}

} // End anonymous namespace


Foam::fsbi::interruption::interruption()
{
    speaker = Pstream::master();
    std::signal(SIGINT, onInterrupt);
    std::signal(SIGTERM, onInterrupt);
    std::signal(SIGUSR1, onInterrupt);
    // a file beyond the user's limit: writing it fails, and says so
    std::signal(SIGXFSZ, SIG_IGN);
}


bool Foam::fsbi::interruption::asked() const
{
    return returnReduce(bool(interrupted), orOp<bool>());
}
