/*---------------------------------------------------------------------------*\
fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dictionaryText.H"
#include "untrapped.H"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace
{

//- Numbers beyond are refused: their sixth powers are still finite with room
//  to spare, and none that is larger means anything in micrometres or metres
const double largestNumber = 1e25;

const std::string sampleHeader
(
    "FoamFile { version 2.0; format ascii; class dictionary; object name; }"
);

std::string onLine(const Foam::label line)
{
    return " on line " + std::to_string(line);
}

} // End anonymous namespace


bool Foam::fsbi::dictionaryText::isOneOf(const char c, const char* set)
{
    return c && std::strchr(set, c);
}


Foam::fsbi::dictionaryText::dictionaryText
(
    const std::string& text, const std::string& className
)
:
    text_(text)
{
    const untrapped scope;      // of nan and 1e400
    includes_ = className.empty();
    checkEncoding();
    if (diagnostic_.empty())
    {
        scopes_.push_back({0, 1, 0, "", 1, {}});
        scan();
    }
    // without a header the rest means nothing
    if (className.size())
    {
        checkHeader(className);
    }
}


void Foam::fsbi::dictionaryText::fail
(
    const label line, const std::string& what
)
{
    if (diagnostic_.empty())
    {
        diagnostic_ = what;
        line_ = line;
    }
}


void Foam::fsbi::dictionaryText::checkEncoding()
{
    const std::string start(text_.substr(0, 3));
    if (text_.find_first_not_of(" \t\r\n") == std::string::npos)
    {
        fail(0, "is empty");
    }
    else if
    (
        start.compare(0, 2, "\xff\xfe") == 0
     || start.compare(0, 2, "\xfe\xff") == 0
     || text_.substr(0, 100).find('\0') != std::string::npos
    )
    {
        fail(0, "is no plain text but UTF-16, or binary: save it as UTF-8");
    }
    else if (start == "\xef\xbb\xbf")
    {
        fail(0, "begins with a byte-order mark: save it as UTF-8 without BOM");
    }
    else if
    (
        text_.find('\r') != std::string::npos
     && text_.find('\n') == std::string::npos
    )
    {
        fail(0, "has lines that end with carriage returns only: save it with"
            " Unix line ends");
    }
}


void Foam::fsbi::dictionaryText::checkHeader(const std::string& className)
{
    if (diagnostic_.size() && line_ == 0)
    {
        return;
    }
    std::string what;
    if (header_.empty())
    {
        what = "does not begin with a header: " + sampleHeader;
    }
    else if (header_["class"] != className)
    {
        what = "has the class '" + header_["class"]
          + "' in its header FoamFile, but is read as " + className;
    }
    else if (header_["format"] != "ascii" && header_["format"] != "binary")
    {
        what = "has the format '" + header_["format"]
          + "' in its header FoamFile; valid choices are 2(ascii binary)";
    }
    else if (header_["version"].empty() || header_["object"].empty())
    {
        what = "has a header FoamFile without version or object: "
          + sampleHeader;
    }
    if (what.size())
    {
        diagnostic_ = what;
        line_ = 1;
    }
}


bool Foam::fsbi::dictionaryText::inDictionary() const
{
    return scopes_.back().opening == 0 || scopes_.back().opening == '{';
}


bool Foam::fsbi::dictionaryText::inHeader() const
{
    return
        scopes_.size() == 2 && scopes_[0].keyword == "FoamFile"
     && scopes_[0].keywords.size() == 1;
}


void Foam::fsbi::dictionaryText::open()
{
    if (inDictionary() && scopes_.back().tokens == 0)
    {
        fail
        (
            atLine_,
            std::string("there is no keyword before '") + text_[at_] + "'"
        );
    }
    scopes_.push_back({text_[at_], atLine_, 0, "", 1, {}});
    skip(1);
}


void Foam::fsbi::dictionaryText::close()
{
    const char closing = text_[at_];
    const scope last(scopes_.back());
    const char opening = closing == '}' ? '{' : closing == ')' ? '(' : '[';
    if (last.opening != opening)
    {
        const std::string open
        (
            last.opening
          ? std::string("'") + last.opening + "'" + onLine(last.line)
          : std::string("nothing")
        );
        fail
        (
            atLine_,
            std::string("'") + closing + "' closes "
          + (last.opening == '{' && last.tokens
              ? "the entry '" + last.keyword + "'" + onLine(last.keywordLine)
                  + ", which has no ';' at its end"
              : open + (last.opening ? ", which wants another" : ""))
        );
    }
    else if (closing == '}' && last.tokens)
    {
        fail
        (
            last.keywordLine,
            "the entry '" + last.keyword + "' has no ';' at its end"
        );
    }
    skip(1);
    if (scopes_.size() > 1)
    {
        scopes_.pop_back();
        if (closing == '}' && inDictionary() && scopes_.back().tokens == 1)
        {
            endEntry();
        }
    }
}


void Foam::fsbi::dictionaryText::endEntry()
{
    if (!inDictionary())
    {
        fail
        (
            scopes_.back().line, std::string("'") + scopes_.back().opening
          + "' that stands here is not closed before the ';'"
          + onLine(atLine_)
        );
    }
    scopes_.back().tokens = 0;
}


void Foam::fsbi::dictionaryText::checkVariable(const std::string& token)
{
    const std::string name
    (
        token.substr(token.find_last_of("${:./") + 1)
    );
    const std::string key(name.substr(0, name.find('}')));
    const std::string whole(token.substr(1 + (token[1] == '{')));
    if
    (
        !includes_ && !all_.count(key)
     && !std::getenv(whole.substr(0, whole.find('}')).c_str())
    )
    {
        fail(atLine_, "there is no entry '" + key + "' for " + token);
    }
}


void Foam::fsbi::dictionaryText::directive(const std::string& token)
{
    includes_ = includes_ || token.compare(0, 8, "#include") == 0;
    mayRepeat_ = mayRepeat_ || token.compare(0, 8, "#include") != 0;
    const position end = std::min(text_.find('\n', at_), text_.size());
    const position from = std::min(text_.find('"', at_), end);
    const position to = text_.find('"', from + 1);
    if (token == "#include" && from < end && to < end)
    {
        included_.push_back(text_.substr(from + 1, to - from - 1));
    }
    at_ = end;
}


void Foam::fsbi::dictionaryText::takeKeyword(const std::string& token)
{
    scope& s = scopes_.back();
    if (token[0] == '#')
    {
        directive(token);
        return;
    }
    if (token[0] == '$')
    {
        checkVariable(token);
        return;
    }
    s.tokens = 1;
    s.keyword = token;
    s.keywordLine = atLine_;
    all_[token] = atLine_;
    const auto inserted = s.keywords.insert({token, atLine_});
    if (!inserted.second && !mayRepeat_)
    {
        fail
        (
            atLine_, "the keyword '" + token + "' stands twice in one"
            " dictionary, first" + onLine(inserted.first->second)
        );
    }
}


void Foam::fsbi::dictionaryText::checkNumber(const std::string& token)
{
    if (!isOneOf(token[0], "+-.0123456789niNI"))
    {
        return;
    }
    char* end = nullptr;
    const double value = std::strtod(token.c_str(), &end);
    if (end != token.c_str() && !*end
     && !(std::isfinite(value) && std::abs(value) <= largestNumber))
    {
        auto s = scopes_.rbegin();
        while (s + 1 != scopes_.rend() && s->keyword.empty())
        {
            ++s;
        }
        fail
        (
            atLine_,
            "the number " + token + " of '" + s->keyword
          + "' cannot be computed with; the largest is 1e25"
        );
    }
}


void Foam::fsbi::dictionaryText::take(const std::string& token)
{
    scope& s = scopes_.back();
    if (inDictionary() && s.tokens == 0)
    {
        takeKeyword(token);
        return;
    }
    if (inHeader() && s.tokens == 1)
    {
        header_[s.keyword] = token;
    }
    ++s.tokens;
    checkNumber(token);
}


void Foam::fsbi::dictionaryText::scan()
{
    while (diagnostic_.empty() && findToken())
    {
        const char c = text_[at_];
        if (isOneOf(c, "{(["))
        {
            open();
        }
        else if (isOneOf(c, "})]"))
        {
            close();
            if (header_.size() && scopes_.size() == 1
             && header_["format"] == "binary")
            {
                return;
            }
        }
        else if (c == ';')
        {
            endEntry();
            skip(1);
        }
        else if (next("#{"))
        {
            skipTo("#}", "code");
        }
        else
        {
            take(c == '"' ? quoted() : word());
        }
    }
    const scope& last = scopes_.back();
    if (last.opening)
    {
        fail
        (
            last.line, std::string("'") + last.opening + "' that stands here"
            " is not closed"
        );
    }
    else if (last.tokens)
    {
        fail
        (
            last.keywordLine,
            "the entry '" + last.keyword + "' has no ';' at its end"
        );
    }
}
