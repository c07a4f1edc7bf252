/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Stands for fsbiFoam in the test of the judge (test_judge.py): does what the
    first word of constant/bodies says.

\*---------------------------------------------------------------------------*/

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static char wish[64];

static int is(const char* what)
{
    return strcmp(wish, what) == 0;
}

static void put(const char* name, const char* text)
{
    FILE* file = fopen(name, "w");
    fputs(text, file);
    fclose(file);
}

static int refuse(const char* text)
{
    printf("--> FOAM FATAL ERROR:\n%s\n\n    From function\n", text);
    return 1;
}

int main(int argc, char** argv)
{
    const int dry = argc > 1 && strcmp(argv[1], "-dry-run") == 0;
    FILE* bodies = fopen("constant/bodies", "r");
    if (!bodies || fscanf(bodies, "%63s", wish) != 1)
    {
        return refuse("constant/bodies cannot be read");
    }
    printf("Scene\n");
    fflush(stdout);
    if (is("crash") || (is("crashLater") && !dry))
    {
        raise(SIGSEGV);
    }
    if (is("trace"))
    {
        printf("#0 Foam::error::printStack\n");
        return refuse("constant/bodies: entry");
    }
    if (is("compute"))
    {
        for (;;) {}
    }
    if (is("wait"))
    {
        pause();
    }
    if (is("memory"))
    {
        char* much = malloc(400000000);
        memset(much, 1, 400000000);
        printf("%d\n", much[399999999]);
    }
    if (is("refuse") || (is("refuseLater") && !dry))
    {
        return refuse("constant/bodies: 'entry' is wrong");
    }
    if (is("refuseVaguely"))
    {
        return refuse("something is wrong");
    }
    if (is("refuseTwice"))
    {
        refuse("constant/bodies: 'entry' is wrong");
        return refuse("constant/bodies: 'entry' is wrong");
    }
    if (is("tell"))
    {
        printf("Warning: 'entry' is not used\n");
    }
    if (dry && is("writeDry"))
    {
        put("constant/left", "");
    }
    if (!dry)
    {
        put("result", is("differ") ? "2" : "1");
    }
    return 0;
}
