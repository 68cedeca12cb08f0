#pragma once
/// Words of the library's enumerations as Python says them.

#include <pybind11/pybind11.h>

#include <string>

#include <spectralpack/names.hpp>

namespace spectralpack::python {

/// The value that `said` is the word of. Throws ValueError naming `what` and all words where there is none.
template <class Enum>
Enum word(const std::string& what, const std::string& said) {
    const auto value = from_string<Enum>(said);
    if (value) return *value;
    const auto known = words_of<Enum>();
    std::string words;
    for (std::size_t i = 0; i < known.size(); ++i) {
        words += (i == 0 ? "'" : i + 1 < known.size() ? ", '" : " or '") + std::string(known[i]) + "'";
    }
    throw pybind11::value_error("there is no " + what + " '" + said + "': it is " + words);
}

}  // namespace spectralpack::python
