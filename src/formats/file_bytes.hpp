#pragma once
/// A whole file in memory: one read, so that what was checked is what is parsed.

#include <filesystem>
#include <memory>
#include <string_view>

#include "spectralpack/stop.hpp"

namespace spectralpack {

class FileBytes {
  public:
    /// Throws InputError for what is not a readable regular file, ResourceError where memory is
    /// short, Stopped once `stop` is requested.
    explicit FileBytes(const std::filesystem::path& path, const StopToken& stop = {});

    std::string_view view() const { return {bytes_.get(), size_}; }

  private:
    struct Free {
        void operator()(char* bytes) const;
    };
    std::unique_ptr<char, Free> bytes_;
    std::size_t size_ = 0;
};

}  // namespace spectralpack
