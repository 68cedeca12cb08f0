#pragma once
/// What a packing leaves over, by reason.

#include <string>
#include <vector>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// A line or two for each reason, the one with the most copies first: the reason, how many, and names with counts as
/// far as `lines` of them hold. Then what would help. Empty where nothing is left over.
std::vector<std::string> left_over_texts(const Packing& packing, StopReason stopped, std::size_t lines);

/// The option that takes what is left over; empty where none of those known does.
std::string what_takes_more(const Packing& packing);

}  // namespace spectralpack::cli
