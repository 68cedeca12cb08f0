#pragma once
/// One word of several.

#include <fmt/format.h>

#include <map>
#include <string>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// What the word stands for. Throws UsageError naming `option` and all its words.
template <class T>
T choose(const std::map<std::string, T>& choices, const std::string& word, const char* option) {
    const auto found = choices.find(word);
    if (found != choices.end()) return found->second;
    std::string known;
    for (const auto& [name, value] : choices) {
        known += (known.empty() ? "" : ", ") + name;
    }
    throw UsageError(fmt::format("{} takes one of {}; not '{}'", option, known, word));
}

}  // namespace spectralpack::cli
