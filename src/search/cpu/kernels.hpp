#pragma once
/// Loops over rows of distances, compiled for every instruction set and chosen at run time
/// (Highway).

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace spectralpack {

/// row[i] = min(row[i], from[i] + 1) for i in [0, count); true when something changed.
bool lower_row(std::uint16_t* row, const std::uint16_t* from, std::size_t count);

/// row[i] = min(row[i], from[i] + by) for i in [0, count); values + by below 256.
void lower_bytes(std::uint8_t* row, const std::uint8_t* from, std::uint8_t by, std::size_t count);

/// out[i] = a[i] + b[i] modulo 2^16.
void add_rows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count);

/// out[i] = min(a[i], b[i]); out may be a.
void min_rows(std::uint16_t* out, const std::uint16_t* a, const std::uint16_t* b, std::size_t count);

/// out[i] = min(out[i], from[i] - floor), the difference modulo 2^16.
void min_rows_above(std::uint16_t* out, const std::uint16_t* from, std::uint16_t floor, std::size_t count);

/// out[i] &= from[i].
void and_rows(std::uint64_t* out, const std::uint64_t* from, std::size_t count);

/// Greatest of row[0..count), 0 for none.
std::uint16_t max_of_row(const std::uint16_t* row, std::size_t count);

/// Names of the instruction sets that are compiled in and that this machine has, the best first.
std::vector<std::string> instruction_sets();

/// For tests: everything runs on this one from now on; empty: on the best. For one thread at a
/// time, while no search runs.
void use_instruction_set(const std::string& name);

}  // namespace spectralpack
