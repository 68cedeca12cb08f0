/// The model inside a 3MF, as XML text: the archive around it is made here, for a fuzzer does not
/// hit checksums.

#include "formats/zip_archive.hpp"
#include "mesh_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    static const std::string relationships =
        "<Relationships><Relationship Target=\"/m\" "
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
    const std::string archive =
        make_zip({{"_rels/.rels", relationships}, {"m", std::string(reinterpret_cast<const char*>(data), size)}});
    try {
        check_meshes(parse_3mf({"file", "file", archive}));
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
    }
    return 0;
}
