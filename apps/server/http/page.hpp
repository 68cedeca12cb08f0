#pragma once
/// The page's files, which are part of this program.

#include <span>
#include <string_view>

namespace spectralpack::server {

struct PageFile {
    std::string_view path;           ///< "assets/index-0a1b.js"
    std::string_view type;           ///< "text/javascript"
    std::string_view etag;           ///< in quotes
    std::string_view bytes, packed;  ///< as it is, and by gzip
};

/// Null where there is none.
const PageFile* find_page_file(std::string_view path);

/// The sample parts: mesh files, and how many of each.
struct SampleFile {
    std::string_view name;
    std::string_view bytes;
};
std::span<const SampleFile> sample_files();

/// openapi.json.
std::string_view api_description();

}  // namespace spectralpack::server
