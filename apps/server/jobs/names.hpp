#pragma once
/// Names that come from outside. None of them is used as a path before it has been through these.

#include <string>
#include <string_view>

namespace spectralpack::server {

/// Twelve small letters and digits.
bool is_job_id(std::string_view text);

/// A new one, at random.
std::string new_job_id();

/// What is wrong with the name of a file that somebody sends, in words; empty: nothing. A good name is a single part of
/// a path, UTF-8, at most 200 bytes, and begins with no dot.
std::string problem_of_name(std::string_view name);

enum class FileKind { mesh, set, job, other };

/// By its ending, whatever the case.
FileKind kind_of(std::string_view name);

/// "%20" becomes a space. False where a % has no two hexadecimal digits behind it.
bool percent_decoded(std::string_view text, std::string& decoded);

}  // namespace spectralpack::server
