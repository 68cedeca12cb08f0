#pragma once
/// Text as people type it: case does not count, and letters get lost.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace spectralpack {

/// Of ASCII letters; other bytes stay.
std::string lower_case(std::string text);

/// ".png" for "build.PNG": the ending of the file's name in lower case.
std::string ending_of(const std::filesystem::path& path);

/// The word that was probably meant: the one with the fewest letters added, left out, changed or swapped with their
/// neighbour, case aside, where those are few for its length; of several, the first. None where no word is near. An
/// abbreviation of three letters or more stands for what it begins; where no word is near, for the first that holds it.
std::optional<std::string> nearest_word(std::string_view typed, std::span<const std::string> words);

}  // namespace spectralpack
