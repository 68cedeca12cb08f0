/// A job file.

#include "formats/job_file.hpp"
#include "mesh_checks.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    try {
        const JobFile job = parse_job("/a/b/job.json", {reinterpret_cast<const char*>(data), size});
        for (const Part& part : job.parts) {
            expect(!part.mesh.file().empty() && part.count >= 0 && part.scale > 0, "parts are valid");
        }
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
    } catch (const UsageError&) {
    }
    return 0;
}
