/// A packing file. What is read and written again must stay the same.

#include "formats/packing_file.hpp"
#include "mesh_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    try {
        const Packing packing = parse_packing("/a/b/p.json", {reinterpret_cast<const char*>(data), size});
        const std::string text = packing_to_json(packing, "/a/b");
        expect(packing_to_json(parse_packing("/a/b/p.json", text), "/a/b") == text, "a packing keeps its content");
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
    }
    return 0;
}
