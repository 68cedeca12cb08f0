#pragma once
/// The sets that tables name, as set files on disk.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "spectralpack/tools/bench.hpp"
#include "spectralpack/tools/generate.hpp"

namespace spectralpack::tools {

/// A set file, and what stands in it and in its meshes.
struct SetOnDisk {
    std::filesystem::path file;
    std::string mesh_dir;        ///< that its paths start from; empty: its own folder
    std::uint64_t contents = 0;  ///< of the set and all its meshes
};

/// Sets of a user's folder, or generated ones.
class BenchSets {
  public:
    /// What is made lies in `folder`. `users`: a folder of set files, their meshes' paths starting from `mesh_dir`;
    /// none: sets are generated.
    BenchSets(std::filesystem::path folder, std::optional<std::filesystem::path> users, std::string mesh_dir,
              BenchScale scale);

    /// "pieces", or "pieces:500" for its first 500 copies. Made where it is not there yet. Throws InputError where the
    /// user's folder does not have it.
    const SetOnDisk& at(const std::string& name);

    /// The folder of the letters, which are always generated.
    std::filesystem::path letters();

    static constexpr std::uint64_t kSeed = 0;  ///< of generated sets

  private:
    SetOnDisk whole(const std::string& name);
    std::filesystem::path generated(const std::string& name);
    std::filesystem::path generated(GeneratedSet set, std::optional<int> copies);
    SetOnDisk first_copies(const SetOnDisk& all, const std::string& name, int copies);

    std::filesystem::path folder_;
    std::optional<std::filesystem::path> users_;
    std::string mesh_dir_;
    BenchScale scale_;
    std::map<std::string, SetOnDisk> known_;
};

/// 64 bits of FNV-1a, over `text` after what came before.
std::uint64_t hash_of(std::string_view text, std::uint64_t before = 0xcbf29ce484222325u);

/// The same over a file's bytes. Throws InputError where it cannot be read.
std::uint64_t hash_of_file(const std::filesystem::path& file, std::uint64_t before = 0xcbf29ce484222325u);

}  // namespace spectralpack::tools
