#pragma once
/// One question to a child process. Its files lie in a job's folder, and go when it is answered.

#include <filesystem>
#include <optional>
#include <string>

#include "jobs/text_files.hpp"

namespace spectralpack::server {

/// The last line that a process said before it ended.
std::string last_line(const std::filesystem::path& file);

struct Question {
    std::filesystem::path asked, answer, errors;

    /// In `folder`, which is made where it is not there. `said`: what is asked, as JSON in the file `asked`; null: the
    /// child's arguments say it.
    Question(const std::filesystem::path& folder, const std::string& name, const Json& said = nullptr);

    std::string why() const { return last_line(errors); }
    void remove() const;
};

}  // namespace spectralpack::server
