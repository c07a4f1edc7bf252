/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later

Description
    Counts what a process of any MPI program sends, by MPI's profiling interface:

        mpicc -shared -fPIC -o countMessages.so countMessages.c
        LD_PRELOAD=$PWD/countMessages.so COUNTS=counts mpirun -np 4 program

    At its end every process writes a file $COUNTS.<rank> with the messages from
    process to process, their bytes, the operations in which all take part
    (reductions, broadcasts, gathers ...) and the most memory [kB] it had.

\*---------------------------------------------------------------------------*/

#include <mpi.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>

static long messages, bytes, collectives;

/* Persistent requests, as PETSc makes them for its scatters, by their handles */
static struct { MPI_Request request; long bytes; } kept[65536];
static int nKept;

static long sizeOf(int count, MPI_Datatype type)
{
    int size;
    PMPI_Type_size(type, &size);
    return (long)count*size;
}

static void sent(long size)
{
    ++messages;
    bytes += size;
}

static void keep(MPI_Request request, long size)
{
    int i = 0;
    while (i < nKept && kept[i].request != request)
    {
        ++i;
    }
    if (i == sizeof(kept)/sizeof(kept[0]))
    {
        fprintf(stderr, "countMessages: too many persistent requests\n");
        exit(1);
    }
    nKept = i < nKept ? nKept : i + 1;
    kept[i].request = request;
    kept[i].bytes = size;
}

static void started(MPI_Request request)
{
    for (int i = 0; i < nKept; ++i)
    {
        if (kept[i].request == request)
        {
            sent(kept[i].bytes);
            return;
        }
    }
}

#define SEND(name) \
int MPI_##name(const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c) \
{ \
    sent(sizeOf(n, t)); \
    return PMPI_##name(b, n, t, to, tag, c); \
}
SEND(Send)
SEND(Bsend)
SEND(Ssend)
SEND(Rsend)

#define ISEND(name) \
int MPI_##name \
( \
    const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r \
) \
{ \
    sent(sizeOf(n, t)); \
    return PMPI_##name(b, n, t, to, tag, c, r); \
}
ISEND(Isend)
ISEND(Issend)
ISEND(Irsend)

int MPI_Send_init
(
    const void* b, int n, MPI_Datatype t, int to, int tag, MPI_Comm c, MPI_Request* r
)
{
    int code = PMPI_Send_init(b, n, t, to, tag, c, r);
    keep(*r, sizeOf(n, t));
    return code;
}

/* The handle of a receiver's request may be that of a sender's before */
int MPI_Recv_init
(
    void* b, int n, MPI_Datatype t, int from, int tag, MPI_Comm c, MPI_Request* r
)
{
    int code = PMPI_Recv_init(b, n, t, from, tag, c, r);
    for (int i = 0; i < nKept; ++i)
    {
        if (kept[i].request == *r)
        {
            kept[i] = kept[--nKept];
        }
    }
    return code;
}

int MPI_Start(MPI_Request* r)
{
    started(*r);
    return PMPI_Start(r);
}

int MPI_Startall(int n, MPI_Request r[])
{
    for (int i = 0; i < n; ++i)
    {
        started(r[i]);
    }
    return PMPI_Startall(n, r);
}

int MPI_Allreduce
(
    const void* s, void* r, int n, MPI_Datatype t, MPI_Op op, MPI_Comm c
)
{
    ++collectives;
    return PMPI_Allreduce(s, r, n, t, op, c);
}

int MPI_Reduce
(
    const void* s, void* r, int n, MPI_Datatype t, MPI_Op op, int root, MPI_Comm c
)
{
    ++collectives;
    return PMPI_Reduce(s, r, n, t, op, root, c);
}

int MPI_Bcast(void* b, int n, MPI_Datatype t, int root, MPI_Comm c)
{
    ++collectives;
    return PMPI_Bcast(b, n, t, root, c);
}

int MPI_Barrier(MPI_Comm c)
{
    ++collectives;
    return PMPI_Barrier(c);
}

int MPI_Allgather
(
    const void* s, int n, MPI_Datatype t, void* r, int m, MPI_Datatype u, MPI_Comm c
)
{
    ++collectives;
    return PMPI_Allgather(s, n, t, r, m, u, c);
}

int MPI_Alltoall
(
    const void* s, int n, MPI_Datatype t, void* r, int m, MPI_Datatype u, MPI_Comm c
)
{
    ++collectives;
    return PMPI_Alltoall(s, n, t, r, m, u, c);
}

int MPI_Finalize(void)
{
    int rank;
    char name[4096];
    struct rusage used;
    FILE* file;
    const char* prefix = getenv("COUNTS");
    PMPI_Comm_rank(MPI_COMM_WORLD, &rank);
    getrusage(RUSAGE_SELF, &used);
    snprintf(name, sizeof(name), "%s.%d", prefix ? prefix : "counts", rank);
    file = fopen(name, "w");
    if (file)
    {
        fprintf
        (
            file, "%ld %ld %ld %ld\n", messages, bytes, collectives, used.ru_maxrss
        );
        fclose(file);
    }
    return PMPI_Finalize();
}
