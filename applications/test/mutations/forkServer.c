/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Preloaded into a program, runs it many times without loading its libraries
    again, which takes longer than to refuse a case: before main() the process
    waits for lines "folder<TAB>log<TAB>argument" on descriptor 3, and for each
    forks a child that continues into main() in that folder, with what it
    prints in that log. Answers on descriptor 4 with "pid" and, when the child
    has ended, with "status peakMemoryInKB".

    gcc -shared -fPIC -o forkServer.so forkServer.c -ldl
\*---------------------------------------------------------------------------*/

#define _GNU_SOURCE
#include <dlfcn.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

typedef int (*mainFunction)(int, char**, char**);
typedef int (*startFunction)
(
    mainFunction, int, char**, void (*)(void), void (*)(void), void (*)(void), void*
);

static mainFunction realMain;

/* In the child: where and with what main() is to run */
static int runCase(char* request, char** argv, char** environment)
{
    const char* folder = strtok(request, "\t\n");
    const char* log = strtok(NULL, "\t\n");
    char* argument = strtok(NULL, "\t\n");
    char* arguments[] = {argv[0], argument, NULL};

    close(3);
    close(4);
    if (!folder || !log || chdir(folder) != 0)
    {
        _exit(125);
    }
    int output = open(log, O_WRONLY | O_CREAT | O_TRUNC | O_APPEND, 0644);
    dup2(output, 1);
    dup2(output, 2);
    close(output);
    setenv("PWD", folder, 1);           /* where OpenFOAM looks for its case */
    return realMain(argument ? 2 : 1, arguments, environment);
}

static int serve(int argc, char** argv, char** environment)
{
    (void)argc;
    char request[4096];
    FILE* requests = fdopen(3, "r");

    unsetenv("LD_PRELOAD");             /* programs it starts are not served */
    while (fgets(request, sizeof(request), requests))
    {
        const pid_t child = fork();
        if (child == 0)
        {
            return runCase(request, argv, environ);
        }
        dprintf(4, "%d\n", child);

        int status = 0;
        struct rusage used;
        wait4(child, &status, 0, &used);
        dprintf(4, "%d %ld\n", status, used.ru_maxrss);
    }
    (void)environment;
    _exit(0);
}

int __libc_start_main
(
    mainFunction program, int argc, char** argv,
    void (*init)(void), void (*fini)(void), void (*unload)(void), void* stackEnd
)
{
    realMain = program;
    startFunction start = (startFunction)dlsym(RTLD_NEXT, "__libc_start_main");
    return start(serve, argc, argv, init, fini, unload, stackEnd);
}
