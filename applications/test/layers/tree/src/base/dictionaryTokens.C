/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

// How the text falls into words, strings and comments

#include "dictionaryText.H"

#include <algorithm>
#include <cctype>
#include <cstring>

void Foam::fsbi::dictionaryText::skip(const position n)
{
    for (position i = 0; i < n && at_ < text_.size(); ++i)
    {
        atLine_ += text_[at_++] == '\n';
    }
}


bool Foam::fsbi::dictionaryText::next(const char* text) const
{
    return text_.compare(at_, std::strlen(text), text) == 0;
}


void Foam::fsbi::dictionaryText::skipTo
(
    const char* text, const std::string& what
)
{
    const label line = atLine_;
    const position end = text_.find(text, at_);
    if (end == std::string::npos)
    {
        fail(line, what + " that begins here is not closed by " + text);
        at_ = text_.size();
        return;
    }
    skip(end - at_ + std::strlen(text));
}


void Foam::fsbi::dictionaryText::comment()
{
    const label line = atLine_;
    const position begin = at_;
    skip(2);
    skipTo("*/", "a comment");
    // a path such as constant/*/material is none
    for
    (
        position i = text_.find("/*", begin + 2);
        i < at_ - 2;
        i = text_.find("/*", i + 1)
    )
    {
        if (std::isspace(static_cast<unsigned char>(text_[i - 1])))
        {
            const label lines =
                std::count(text_.begin() + begin, text_.begin() + i, '\n');
            fail
            (
                line, "a comment that begins here has the beginning of another"
                " on line " + std::to_string(line + lines)
              + ": is it not closed by */?"
            );
        }
    }
}


bool Foam::fsbi::dictionaryText::findToken()
{
    while (at_ < text_.size())
    {
        if (next("//"))
        {
            const position end = text_.find('\n', at_);
            at_ = end == std::string::npos ? text_.size() : end;
        }
        else if (next("/*"))
        {
            comment();
        }
        else if (std::isspace(static_cast<unsigned char>(text_[at_])))
        {
            skip(1);
        }
        else
        {
            return true;
        }
    }
    return false;
}


std::string Foam::fsbi::dictionaryText::quoted()
{
    const label line = atLine_;
    const position begin = at_;
    for (skip(1); at_ < text_.size(); skip(1))
    {
        if (text_[at_] == '\\')
        {
            skip(1);
        }
        else if (text_[at_] == '"')
        {
            skip(1);
            return text_.substr(begin, at_ - begin);
        }
        else if (text_[at_] == '\n')
        {
            break;
        }
    }
    fail(line, "a string that begins here is not closed by \"");
    return "\"";
}


std::string Foam::fsbi::dictionaryText::word()
{
    const position begin = at_;
    if (next("${"))
    {
        skipTo("}", "a variable");
        return text_.substr(begin, at_ - begin);
    }
    // as OpenFOAM does: words may hold pairs of parentheses, numbers none
    const bool number = isOneOf(text_[at_], "+-.0123456789");
    label depth = 0;
    for (; at_ < text_.size(); skip(1))
    {
        const char c = text_[at_];
        depth += c == '(';
        depth -= c == ')';
        if
        (
            std::isspace(static_cast<unsigned char>(c))
         || isOneOf(c, number ? "{};\"()[]" : "{};\"") || depth < 0
         || (at_ > begin && (next("//") || next("/*")))
        )
        {
            break;
        }
    }
    return text_.substr(begin, at_ - begin);
}
