#pragma once
/// The files beside prepared meshes (docs/format.md): the report, and the journal that lets a run go on where
/// another one stopped.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <vector>

#include "spectralpack/geometry.hpp"

namespace spectralpack::tools {

/// What became of one mesh, or of a file that could not be read.
struct PreparedRow {
    std::string file;     ///< relative to the folder that was prepared
    int object = 1;       ///< counted from 1; 0: the file as a whole
    std::string outcome;  ///< one word or two
    std::string detail;
    std::string mesh;  ///< the result, relative to the output; empty where dropped
    std::int64_t triangles_before = 0, triangles_after = 0;
    Vec3 size;          ///< of the result, mm
    double volume = 0;  ///< of the result, mm^3
    double scale = 1;   ///< applied
    std::string repairs;

    bool operator==(const PreparedRow&) const = default;
};

/// A file that is done, and what it was like then.
struct PreparedFile {
    std::int64_t bytes = 0;
    std::int64_t modified = 0;  ///< in the file system's own count
    std::vector<PreparedRow> rows;

    bool operator==(const PreparedFile&) const = default;
};

/// CSV with a header, one row each, in the order given. Whole or not at all.
void write_prepare_report(const std::vector<PreparedRow>& rows, const std::filesystem::path& path);

/// Rows of files that are done, on disk as soon as they are added. What a run that was killed left half written is
/// dropped by the next one.
class PrepareJournal {
  public:
    /// Reads what is there and goes on behind it. `settings`: what the results depend on, as text; throws UsageError
    /// where the journal was begun with others, ResourceError where it cannot be written.
    PrepareJournal(std::filesystem::path path, const std::string& settings);

    /// By PreparedRow::file.
    const std::map<std::string, PreparedFile>& files() const { return files_; }

    /// Remembers what became of a file, in place of what was known of it. Throws ResourceError.
    void add(const std::string& name, PreparedFile file);

  private:
    std::filesystem::path path_;
    std::map<std::string, PreparedFile> files_;
    std::ofstream out_;
};

}  // namespace spectralpack::tools
