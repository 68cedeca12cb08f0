/// A run that goes on from a journal whose decisions were not made by any run: it ends with a packing or a refusal.

#include <spectralpack/spectralpack.hpp>

#include "journals.hpp"

namespace {

using namespace spectralpack;

Mesh block(double x, double y, double z) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i) {
        mesh.vertices.push_back({i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0});
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

Job small_job() {
    Job job;
    job.parts = {{.name = "block", .mesh = block(9, 9, 9), .count = 3},
                 {.name = "bar", .mesh = block(15, 4, 3), .count = 4}};
    job.options.tray = {24, 20, 12};
    job.options.voxel = 3;
    job.options.gap = 0.5;
    job.options.trays = 2;
    job.options.threads = 1;
    return job;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const Job job = small_job();
    static const std::vector<std::string> head = [] {
        const JournalInMemory journal;
        static_cast<void>(pack(job, {}, {journal.path(), 0, Resume::never}));
        return head_of(read_journal(journal.path()).records);
    }();
    const JournalInMemory journal;
    std::vector<std::string> records = head;
    append_lines(records, data, size);
    journal.write(records);
    try {
        static_cast<void>(pack(job, {}, {journal.path(), 0, Resume::must}));
    } catch (const Error& error) {
        expect(*error.what() != 0, "a refusal says why");
    }
    return 0;
}
