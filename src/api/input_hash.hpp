#pragma once
/// What a packing was made of, as hashes: all of it in one, and fact by fact.

#include <string>
#include <vector>

#include "api/load.hpp"

namespace spectralpack {

/// Hash of all that placements depend on: meshes, counts, scales, container and options. 32 hexadecimal digits.
std::string input_hash(const LoadedJob& loaded, const Container& container, const PackOptions& options);

/// One thing that placements or plans depend on: "option gap", "0.2". A mesh's value is its hash.
struct InputFact {
    std::string name, value;

    bool operator==(const InputFact&) const = default;
};

/// All such things, each once, in an order that depends on nothing but them.
std::vector<InputFact> input_facts(const LoadedJob& loaded, const Container& container, const PackOptions& options);

/// 16 hexadecimal digits of a hash of `text`, which depends on what was hashed before: `before` is that hash's digits,
/// empty for the first.
std::string chained_hash(const std::string& before, const std::string& text);

}  // namespace spectralpack
