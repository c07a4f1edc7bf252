/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "caseFingerprint.H"
#include "IFstream.H"
#include "IStringStream.H"
#include "OStringStream.H"
#include "SHA1.H"

#include <sstream>

namespace Foam
{
namespace fsbi
{

//- Keywords and values of a dictionary; numbers with as many digits as
//  foamDictionary, which writes samples' bodies, keeps
static void print(const dictionary& dict, OStringStream& os)
{
    for (const entry& e : dict)
    {
        os << e.keyword() << ' ';
        if (e.isDict())
        {
            print(e.dict(), os);
            continue;
        }
        for (const token& t : e.stream())
        {
            os << t << ' ';
        }
    }
}


//- A file as it is; nothing if it is not there
static std::string contentOf(const fileName& file)
{
    std::ostringstream os;
    if (isFile(file))
    {
        const IFstream is(file);
        os << is.stdStream().rdbuf();
    }
    return os.str();
}


static string textOf(const SHA1& sum)
{
    OStringStream digest;
    digest << sum.digest();
    return digest.str();
}

} // End namespace fsbi
} // End namespace Foam


Foam::string Foam::fsbi::caseFingerprint
(
    const Time& time, const UPtrList<rigidBody>& bodies
)
{
    SHA1 sum;
    for (const rigidBody& body : bodies)
    {
        dictionary saved;
        body.save(saved);
        IStringStream is(saved.get<string>("shape"));
        OStringStream os;
        os.precision(5);
        os << body.name() << ' ';
        print(dictionary(is), os);
        sum.append(os.str());
    }
    const fileName root(time.globalPath());
    for
    (
        const fileName& file :
        {
            root/"constant"/"fluid"/"material",
            root/"system"/"blockMeshDict",
            root/"system"/"domainDict",
            root/"system"/"remeshDict"
        }
    )
    {
        sum.append(file.name() + ' ');
        sum.append(contentOf(file));
    }
    return textOf(sum);
}


Foam::string Foam::fsbi::flowFingerprint(const Time& time)
{
    // a run writes its start to 0: only 0.orig stays as the user has it, and in
    // copies of a study, which have none, 0 until then
    const fileName flow(fileName("fluid")/"U");
    fileName start(time.globalPath()/"0.orig"/flow);
    if (!isFile(start) && time.value() == 0)
    {
        start = time.globalPath()/"0"/flow;
    }
    SHA1 sum;
    sum.append(contentOf(start));
    return isFile(start) ? textOf(sum) : string();
}
