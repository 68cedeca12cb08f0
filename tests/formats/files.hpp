#pragma once
/// Files made in code, for the tests of this room.

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <string>
#include <vector>

#include "formats/mesh_reader.hpp"
#include "spectralpack/error.hpp"
#include "support/names.hpp"
#include "support/process.hpp"

namespace spectralpack::test {

inline std::filesystem::path write_bytes(const std::filesystem::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
}

template <class T>
std::string bytes_of(T value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    return bytes;
}

inline std::string binary_stl(const Mesh& mesh, std::string header = "") {
    header.resize(80);
    std::string bytes = header + bytes_of(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const Triangle& t : mesh.triangles) {
        bytes.append(12, '\0');
        for (const std::uint32_t corner : t) {
            for (int axis = 0; axis < 3; ++axis) {
                bytes += bytes_of(static_cast<float>(mesh.vertices[corner][axis]));
            }
        }
        bytes.append(2, '\0');
    }
    return bytes;
}

/// Reads `bytes` as a file of this name.
inline std::vector<LoadedMesh> read_as(const std::string& name, const std::string& bytes) {
    const TemporaryFolder folder;
    return read_meshes(write_bytes(folder / name, bytes));
}

/// The InputError that `action` throws; a failure where it throws none.
template <class Action>
InputError refusal(Action action) {
    try {
        action();
    } catch (const InputError& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was refused";
    return InputError("", "", "");
}

inline InputError refusal_of(const std::string& name, const std::string& bytes) {
    return refusal([&] { read_as(name, bytes); });
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace spectralpack::test
