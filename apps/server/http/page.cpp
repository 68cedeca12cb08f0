#include "http/page.hpp"

#include <algorithm>
#include <iterator>

namespace spectralpack::server {

#include <embedded/tables.inc>  // made by embed.cmake

// The last of each table is empty, because no array may be.
const PageFile* find_page_file(std::string_view path) {
    const auto* end = std::prev(std::end(kPageFiles));
    const auto* found =
        std::find_if(std::begin(kPageFiles), end, [&](const PageFile& file) { return file.path == path; });
    return found == end ? nullptr : found;
}

std::span<const SampleFile> sample_files() { return {std::begin(kSampleFiles), std::size(kSampleFiles) - 1}; }

std::string_view api_description() { return {sp_api, static_cast<std::size_t>(sp_api_end - sp_api)}; }

}  // namespace spectralpack::server
