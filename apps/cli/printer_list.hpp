#pragma once
/// --printer list.

#include <span>

#include <spectralpack/spectralpack.hpp>

namespace spectralpack::cli {

/// Prints the user's own printers and those that are known, for people or as a file of printers.
void print_printers(std::span<const Printer> own, bool json);

}  // namespace spectralpack::cli
