#pragma once
/// A whole file in memory: one read, so that what was checked is what is parsed.

#include <filesystem>
#include <memory>
#include <string_view>

namespace spectralpack {

class FileBytes {
  public:
    /// Throws InputError for what is not a readable regular file, ResourceError where memory is
    /// short.
    explicit FileBytes(const std::filesystem::path& path);

    std::string_view view() const { return {bytes_.get(), size_}; }

  private:
    struct Free {
        void operator()(char* bytes) const;
    };
    std::unique_ptr<char, Free> bytes_;
    std::size_t size_ = 0;
};

}  // namespace spectralpack
