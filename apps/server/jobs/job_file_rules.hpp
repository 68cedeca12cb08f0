#pragma once
/// What a job file may say that comes from outside.

#include <string>

#include "jobs/text_files.hpp"

namespace spectralpack::server {

struct Job;

/// Throws Refusal naming the key where the job file names a mesh that is not, by its plain name, one of the job's
/// files, or says an option that names files or is the command line's own. What is wrong otherwise, `pack` says.
void require_harmless(const Json& said, const Job& job);

/// The option may be said in a job file here.
bool is_allowed_here(const std::string& option);

/// Throws Refusal where one of the job's files is no plain file of its folder, but a link, say.
void require_plain_files(const Job& job);

}  // namespace spectralpack::server
