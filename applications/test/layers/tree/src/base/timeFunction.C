/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "timeFunction.H"

namespace Foam
{
namespace fsbi
{

//- Values that stand one after the other: numbers, words, (...) with the size
//  that may stand before it
static label valuesIn(const UList<token>& tokens)
{
    label values = 0, depth = 0;
    forAll(tokens, i)
    {
        const token& t = tokens[i];
        const bool opens = t == token::BEGIN_LIST;
        const bool sized = opens && i > 0 && tokens[i - 1].isLabel();
        values += depth == 0 && !sized;
        depth += opens;
        depth -= t == token::END_LIST;
    }
    return values;
}

} // End namespace fsbi
} // End namespace Foam


void Foam::fsbi::checkFunctionEntry
(
    const word& key, const dictionary& dict, const wordList& types
)
{
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    if (!e || !e->isStream() || e->stream().empty())
    {
        return;
    }
    const tokenList& tokens = e->stream();
    const bool named = tokens[0].isWord();
    if (named && !types.found(tokens[0].wordToken()))
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' on line " << e->startLineNumber()
            << " is '" << tokens[0].wordToken() << "', but must be a value or"
            << " a function of time, one of " << flatOutput(types)
            << exit(FatalIOError);
    }
    if (valuesIn(tokens) > 1 + named)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' on line " << e->startLineNumber()
            << " has more than a function of time: " << flatOutput(tokens)
            << ". Is there no ';' at its end?" << exit(FatalIOError);
    }
}
