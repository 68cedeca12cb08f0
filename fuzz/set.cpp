/// A set file.

#include "formats/set_file.hpp"
#include "mesh_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    try {
        for (const SetRow& row : parse_set("file", {reinterpret_cast<const char*>(data), size})) {
            expect(!row.mesh.empty() && row.count >= 1 && row.scale > 0 && row.line > 1, "rows are valid");
        }
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
    }
    return 0;
}
