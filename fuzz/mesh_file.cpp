/// A mesh file of one format, as bytes.

#include "mesh_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    try {
        check_meshes(FUZZ_PARSER({"file", "file", {reinterpret_cast<const char*>(data), size}}));
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
    }
    return 0;
}
