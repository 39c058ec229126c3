// The answer of anything that reads what a user wrote: a value, or one sentence the user can act on.
//
// Promise    `core` never prints, exits or throws for bad input; it returns an Error
// Text       Error::text() is "file:line: sentence" with the parts that are known
#pragma once

#include <cassert>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace zscope {

/// What kind of answer the caller owes its user; the command line maps each to an exit status.
enum class Trouble {
    Usage,      // the request itself is wrong (unknown word, value out of range)
    Input,      // a file or scene cannot be used
    Output,     // something cannot be written
    Limit,      // memory or another stated limit would be exceeded
    Cancelled,  // somebody asked to stop
};

struct Error {
    Trouble     kind = Trouble::Input;
    std::string sentence;   // one sentence, no trailing newline
    std::string file = {};  // empty: no file concerned
    int         line = 0;   // 1-based; 0: no line concerned

    std::string text() const
    {
        if (file.empty()) return sentence;
        if (line <= 0) return file + ": " + sentence;
        return file + ":" + std::to_string(line) + ": " + sentence;
    }
};

inline Error inputError(std::string sentence, std::string file = {}, int line = 0)
{
    return {Trouble::Input, std::move(sentence), std::move(file), line};
}

/// Something that was left out or mended while reading, worth telling; never fatal.
struct Warning {
    std::string file;
    int         line = 0;
    std::string sentence;
};

template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_answer(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_answer(std::in_place_index<1>, std::move(error)) {}

    bool     ok() const { return m_answer.index() == 0; }
    explicit operator bool() const { return ok(); }

    T& value() &
    {
        assert(ok());
        return std::get<0>(m_answer);
    }
    const T& value() const&
    {
        assert(ok());
        return std::get<0>(m_answer);
    }
    T&& value() &&
    {
        assert(ok());
        return std::get<0>(std::move(m_answer));
    }
    const Error& error() const
    {
        assert(!ok());
        return std::get<1>(m_answer);
    }

    T*       operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    T&       operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T&&      operator*() && { return std::move(*this).value(); }

private:
    std::variant<T, Error> m_answer;
};

/// For actions that have no value to give back.
struct Done {};

}  // namespace zscope
