/// A journal: what is recalled of it is written again, and that is read. Also the bytes as they are, as a file.

#include <sstream>

#include "api/journal/run_journal.hpp"
#include "journals.hpp"

namespace spectralpack {
namespace {

/// Asks for every decision in the order of the records, and keeps it in another journal.
void keep_again(const std::vector<std::string>& decisions, RunJournal& from, RunJournal& to) {
    std::size_t begun = 0;
    const auto keep = [&](const auto& known) {
        if (known) to.keep(*known);
    };
    for (const std::string& record : decisions) {
        std::istringstream words(record);
        std::string word;
        std::size_t filling = 0;
        Copy copy{};
        words >> word >> filling >> copy.part >> copy.number;
        for (; begun < filling; ++begun) {
            from.begin_filling();
            to.begin_filling();
        }
        if (begun != filling) continue;
        try {
            if (word == "place") keep(from.recall_place(copy));
            if (word == "settled") keep(from.recall_settled(copy));
            if (word == "packed") keep(from.recall_packed());
            if (word == "apart") keep(from.recall_taken_apart());
            if (word == "filled") keep(from.recall_filled());
        } catch (const InternalError&) {  // the next is about another copy
        }
    }
}

}  // namespace
}  // namespace spectralpack

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace spectralpack;
    Listener quiet;
    const JournalInMemory journal, again;
    std::ofstream(journal.path(), std::ios::binary).write(reinterpret_cast<const char*>(data), std::streamsize(size));
    expect(read_journal(journal.path()).bytes <= size, "no more is read than is there");

    { const RunJournal fresh({again.path(), 0, Resume::never}, {}, quiet); }
    std::vector<std::string> records = read_journal(again.path()).records, decisions;
    append_lines(decisions, data, size);
    records.insert(records.end(), decisions.begin(), decisions.end());
    journal.write(records);
    try {
        RunJournal from({journal.path(), 0, Resume::must}, {}, quiet);
        RunJournal to({again.path(), 0, Resume::never}, {}, quiet);
        keep_again(decisions, from, to);
    } catch (const InputError& error) {
        expect(!error.cause().empty(), "a refusal says why");
        return 0;
    }
    const RunJournal read_back({again.path(), 0, Resume::must}, {}, quiet);
    return 0;
}
