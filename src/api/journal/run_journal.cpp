#include "api/journal/run_journal.hpp"

#include <algorithm>
#include <utility>

#include "api/journal/record_text.hpp"
#include "spectralpack/error.hpp"

namespace spectralpack {

// What records hold. Ids of objects are not among it: they are the tray's own.

template <class Archive>
static void record_values(Archive& archive, ConstOrNot<Copy> auto& copy) {
    archive(copy.part, copy.number);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<VoxelIndex> auto& q) {
    archive(q.x, q.y, q.z);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<Vec3> auto& v) {
    archive(v.x, v.y, v.z);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<Cost> auto& cost) {
    archive(cost.primary, cost.secondary);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<BestPlacement> auto& best) {
    archive(best.index, best.position, best.proximity, best.cost);
    for (auto& neighbour : best.neighbours) {
        archive(neighbour);
    }
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<PlacedCopy> auto& placed) {
    archive(placed.copy, placed.orientation, placed.position, placed.offset, placed.cost);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<RemovalStep> auto& step) {
    archive(step.placements, step.path);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<Disassembly> auto& plan) {
    archive(plan.complete, plan.steps, plan.interlocked, plan.unpack, plan.through_walls);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<InterlockCounts> auto& counts) {
    archive(counts.straight, counts.flooded, counts.groups, counts.fills, counts.removed, counts.reinserted,
            counts.added);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<InterlockReport> auto& report) {
    archive(report.counts, report.changed, report.least_gap, report.disassemble_seconds, report.reinsert_seconds);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<GreedyResult> auto& result) {
    archive(result.placed, result.left_over, result.untried, result.searches, result.why);
}

template <class Archive>
static void record_values(Archive& archive, ConstOrNot<FoundPlace> auto& found) {
    archive(found.copy, found.layers, found.best);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<SettledCopy> auto& settled) {
    archive(settled.copy, settled.offset);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<PackedTray> auto& packed) {
    archive(packed.layers, packed.result);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<TakenApart> auto& apart) {
    archive(apart.out, apart.plan, apart.counts);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<FilledTray> auto& filled) {
    archive(filled.placed, filled.left_over, filled.untried, filled.searches, filled.why, filled.interlocked,
            filled.plan, filled.report, filled.height_at, filled.least_gap);
}
template <class Archive>
static void record_values(Archive& archive, ConstOrNot<ImprovedTray> auto& improved) {
    archive(improved.steps, improved.starts, improved.seconds, improved.x, improved.y, improved.tray);
}

namespace {

constexpr const char* kFormat = "spectralpack-journal";
constexpr int kVersion = 1;
constexpr const char* kProgram = SPECTRALPACK_VERSION;

std::string first_record() {
    RecordWriter record(kFormat);
    record(kVersion, std::string(kProgram));
    return record.text();
}

std::string fact_record(const InputFact& fact) {
    RecordWriter record("fact");
    record(fact.name, fact.value);
    return record.text();
}

constexpr const char* kBegun = "begun";

/// What is another than these facts say; empty where nothing is. `decisions`: where those begin.
std::string difference(const std::vector<std::string>& records, const std::vector<InputFact>& facts,
                       std::size_t& decisions) {
    const auto begun = std::ranges::find(records, kBegun);
    if (records.empty()) return "it is empty";
    if (records.front() != first_record()) {
        int version = 0;
        std::string program;
        RecordReader record(records.front());
        record(version, program);
        return "it was written by spectralpack " + program + ", this is " + kProgram;
    }
    if (begun == records.end()) return "it ends before the first decision";
    decisions = static_cast<std::size_t>(begun - records.begin()) + 1;
    std::vector<InputFact> there;
    for (auto record = records.begin() + 1; record != begun; ++record) {
        InputFact& fact = there.emplace_back();
        RecordReader reader(*record);
        reader(fact.name, fact.value);
        if (!reader.ok() || reader.word() != "fact") return "it cannot be understood";
    }
    const auto is_short = [](const std::string& value) { return value.size() < 32; };  // hashes say nothing to people
    for (std::size_t i = 0; i < std::max(there.size(), facts.size()); ++i) {
        if (i < there.size() && i < facts.size() && there[i] == facts[i]) continue;
        if (i == facts.size()) return there[i].name + " is there, and not here";
        if (i == there.size()) return facts[i].name + " is here, and not there";
        if (there[i].name != facts[i].name) return there[i].name + " there, " + facts[i].name + " here";
        if (!is_short(there[i].value) || !is_short(facts[i].value)) return facts[i].name + " differs";
        const auto shown = [](const std::string& value) { return value.empty() ? std::string("none") : value; };
        return facts[i].name + " is " + shown(there[i].value) + " there and " + shown(facts[i].value) + " here";
    }
    return "";
}

/// The journal that is there; none where no file is. A file that is something else is not written over.
std::optional<JournalText> journal_at(const std::filesystem::path& path) {
    std::error_code unknown;
    if (!std::filesystem::is_regular_file(path, unknown)) return std::nullopt;
    JournalText text = read_journal(path);
    const bool empty = text.bytes == 0 && !text.damaged;
    if (empty || (!text.records.empty() && text.records.front().starts_with(kFormat))) return text;
    throw InputError(path.string(), "", "is there, and is not a journal; it is left as it is");
}

}  // namespace

RunJournal::RunJournal(const JournalOptions& options, const std::vector<InputFact>& facts, Listener& listener)
    : path_(options.file), listener_(listener) {
    std::optional<JournalText> standing = journal_at(path_);
    if (!standing && options.resume == Resume::must) throw InputError(path_.string(), "", "there is no such journal");
    if (standing && (options.resume == Resume::never || !goes_on(*standing, options.resume, facts))) standing.reset();
    file_ = std::make_unique<JournalFile>(path_, options.after, standing ? &*standing : nullptr);
    if (!standing) begin(facts);
    told_of_file_ = standing || options.after <= 0;  // who asked for it knows
}

/// Takes what the journal decided; false where it is of another job.
bool RunJournal::goes_on(const JournalText& standing, Resume resume, const std::vector<InputFact>& facts) {
    std::size_t decisions = 0;
    const std::string differs = difference(standing.records, facts, decisions);
    if (!differs.empty()) {
        if (resume == Resume::must) throw InputError(path_.string(), "", "is not of this job: " + differs);
        listener_.on_warning(path_.string() + " is not of this job (" + differs + "): this run begins anew");
        return false;
    }
    for (std::size_t i = decisions; i < standing.records.size(); ++i) {
        take_record(standing.records[i]);
    }
    listener_.on_warning("this run goes on from " + path_.string() + ": " + what_is_known() +
                         "; --no-resume begins anew" +
                         (standing.damaged ? ". What stood last in it was torn, and is decided again" : ""));
    return true;
}

/// For people: how many copies were tried, in all fillings.
std::string RunJournal::what_is_known() const {
    std::int64_t tried = 0;
    for (const Filling& filling : fillings_) {
        tried += filling.filled   ? filling.filled->searches
                 : filling.packed ? filling.packed->result.searches + std::ssize(filling.places)
                                  : std::ssize(filling.places);
    }
    return tried == 1 ? "1 copy was tried by then" : std::to_string(tried) + " copies were tried by then";
}

void RunJournal::begin(const std::vector<InputFact>& facts) {
    file_->add(first_record());
    for (const InputFact& fact : facts) {
        file_->add(fact_record(fact));
    }
    file_->add(kBegun);
}

void RunJournal::take_record(const std::string& record) {
    RecordReader reader(record);
    std::size_t number = 0;
    reader(number);
    const auto read = [&]<class T>(T value) {
        reader(value);
        return value;
    };
    // Fillings come one after the other.
    if (number == 0 || number < fillings_.size() || number > fillings_.size() + 1) {
        throw InputError(path_.string(), "record '" + std::string(reader.word()) + "'", "is out of order");
    }
    fillings_.resize(number);
    Filling& filling = fillings_.back();
    if (reader.word() == "place") {
        filling.places.push_back(read(FoundPlace{}));
    } else if (reader.word() == "settled") {
        filling.settled.push_back(read(SettledCopy{}));
    } else if (reader.word() == "packed") {
        filling = {};
        filling.packed = read(PackedTray{});
    } else if (reader.word() == "apart") {
        filling.taken_apart = read(TakenApart{});
    } else if (reader.word() == "filled") {
        filling = {};
        filling.filled = read(FilledTray{});
    } else if (reader.word() == "improved") {
        filling.improved = read(ImprovedTray{});
    } else {
        throw InputError(path_.string(), "record '" + std::string(reader.word()) + "'", "is not known");
    }
    if (!reader.ok()) throw InputError(path_.string(), "record '" + std::string(reader.word()) + "'", "is not whole");
}

void RunJournal::begin_filling() { ++filling_; }

template <class T>
std::optional<T> RunJournal::recall(std::optional<T> Filling::*decision) {
    if (filling_ > fillings_.size()) return std::nullopt;
    std::optional<T> known = std::exchange(fillings_[filling_ - 1].*decision, std::nullopt);
    if (known) ++recalled_;
    return known;
}

template <class T>
std::optional<T> RunJournal::recall_next(std::deque<T> Filling::*decisions, const Copy& copy) {
    if (filling_ > fillings_.size()) return std::nullopt;
    std::deque<T>& known = fillings_[filling_ - 1].*decisions;
    if (known.empty()) return std::nullopt;
    T next = std::move(known.front());
    known.pop_front();
    if (next.copy != copy) {
        throw InternalError("the journal " + path_.string() +
                            " does not fit this run, though it is of the same job; --no-resume begins anew");
    }
    ++recalled_;
    return next;
}

std::optional<FoundPlace> RunJournal::recall_place(const Copy& copy) { return recall_next(&Filling::places, copy); }
std::optional<SettledCopy> RunJournal::recall_settled(const Copy& copy) { return recall_next(&Filling::settled, copy); }
std::optional<PackedTray> RunJournal::recall_packed() { return recall(&Filling::packed); }
std::optional<TakenApart> RunJournal::recall_taken_apart() { return recall(&Filling::taken_apart); }
std::optional<FilledTray> RunJournal::recall_filled() { return recall(&Filling::filled); }
std::optional<ImprovedTray> RunJournal::recall_improved() { return recall(&Filling::improved); }

template <class T>
void RunJournal::write(const char* word, const T& decision) {
    RecordWriter record(word);
    record(filling_, decision);
    file_->add(record.text());
    tell();
}

void RunJournal::keep(const FoundPlace& found) { write("place", found); }
void RunJournal::keep(const SettledCopy& settled) { write("settled", settled); }
void RunJournal::keep(const PackedTray& packed) { write("packed", packed); }
void RunJournal::keep(const TakenApart& taken_apart) { write("apart", taken_apart); }
void RunJournal::keep(const FilledTray& filled) { write("filled", filled); }
void RunJournal::keep(const ImprovedTray& improved) { write("improved", improved); }

/// Of what the file has become meanwhile, once.
void RunJournal::tell() {
    if (!told_of_file_ && file_->on_disk()) {
        told_of_file_ = true;
        listener_.on_warning("a journal is kept in " + path_.string() +
                             ": if this run is cut off, the same command goes on from there");
    }
    if (told_of_failure_) return;
    if (const std::optional<std::string> failure = file_->failure()) {
        told_of_failure_ = true;
        listener_.on_warning("the journal " + path_.string() + " cannot be written (" + *failure +
                             "): if this run is cut off, it has to begin anew");
    }
}

JournalUse RunJournal::use() const { return {path_, recalled_, file_->on_disk()}; }

}  // namespace spectralpack
