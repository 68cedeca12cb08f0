#include "formats/threemf_origin.hpp"

#include "formats/file_bytes.hpp"
#include "formats/zip_archive.hpp"
#include "spectralpack/error.hpp"
#include "spectralpack/typed_text.hpp"

namespace spectralpack {
namespace {

/// What write_3mf() writes is this near to the model's beginning.
constexpr std::size_t kHead = 2048;

}  // namespace

bool is_own_build(const std::filesystem::path& path) {
    if (ending_of(path) != ".3mf") return false;
    try {
        const FileBytes bytes(path);
        const std::string head = ZipReader(path.string(), bytes.view()).head("3D/3dmodel.model", kHead);
        return head.find("<metadata name=\"Application\">spectralpack ") != std::string::npos;
    } catch (const InputError&) {
        return false;  // whoever reads it says why
    }
}

}  // namespace spectralpack
