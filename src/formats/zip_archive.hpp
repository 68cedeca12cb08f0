#pragma once
/// ZIP archives in memory. The only place that sees the ZIP library.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace spectralpack {

/// An archive to read from. Nothing is ever written to disk, so entry names are names only.
class ZipReader {
  public:
    /// `bytes` must outlive the reader. Throws InputError naming `file`.
    ZipReader(std::string file, std::string_view bytes);
    ~ZipReader();
    ZipReader(const ZipReader&) = delete;
    ZipReader& operator=(const ZipReader&) = delete;

    bool has(const std::string& entry) const;

    /// Unpacks `entry` piece by piece into consume(). Throws InputError where the entry is missing,
    /// damaged (its checksum is verified at the end), of a kind that cannot be unpacked, or larger
    /// than max_bytes.
    void unpack(const std::string& entry, std::uint64_t max_bytes,
                const std::function<void(std::string_view)>& consume) const;

    /// The first bytes of `entry`, so many or all. Throws like unpack().
    std::string head(const std::string& entry, std::size_t bytes) const;

  private:
    struct Archive;
    std::string file_;
    std::unique_ptr<Archive> archive_;
};

struct ZipEntry {
    std::string name;
    std::string content;
};

/// The bytes of an archive of these entries, deflated; equal entries give equal bytes (no time
/// stamps).
std::string make_zip(const std::vector<ZipEntry>& entries);

}  // namespace spectralpack
