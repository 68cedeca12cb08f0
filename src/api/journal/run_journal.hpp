#pragma once
/// The decisions of a run, kept in a journal and recalled from the one of an earlier run.
///
/// The first record names format and program, those after it the facts that the run depends on, "begun" ends them. Then
/// every record begins with the number of its filling.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "api/input_hash.hpp"
#include "api/journal/journal_file.hpp"
#include "packing/tray/decisions.hpp"
#include "spectralpack/events.hpp"
#include "spectralpack/journal.hpp"

namespace spectralpack {

class RunJournal final : public Decisions {
  public:
    /// Reads what is there as `options` say, and says what it does with it. Throws as Resume::must says.
    RunJournal(const JournalOptions& options, const std::vector<InputFact>& facts, Listener& listener);

    void begin_filling() override;
    std::optional<FoundPlace> recall_place(const Copy& copy) override;
    std::optional<SettledCopy> recall_settled(const Copy& copy) override;
    std::optional<PackedTray> recall_packed() override;
    std::optional<TakenApart> recall_taken_apart() override;
    std::optional<FilledTray> recall_filled() override;
    std::optional<ImprovedTray> recall_improved() override;
    void keep(const FoundPlace& found) override;
    void keep(const SettledCopy& settled) override;
    void keep(const PackedTray& packed) override;
    void keep(const TakenApart& taken_apart) override;
    void keep(const FilledTray& filled) override;
    void keep(const ImprovedTray& improved) override;

    JournalUse use() const;

  private:
    /// What is known of one filling.
    struct Filling {
        std::deque<FoundPlace> places;
        std::deque<SettledCopy> settled;
        std::optional<PackedTray> packed;
        std::optional<TakenApart> taken_apart;
        std::optional<FilledTray> filled;
        std::optional<ImprovedTray> improved;
    };

    bool goes_on(const JournalText& standing, Resume resume, const std::vector<InputFact>& facts);
    void take_record(const std::string& record);
    std::string what_is_known() const;
    template <class T>
    std::optional<T> recall(std::optional<T> Filling::*decision);
    template <class T>
    std::optional<T> recall_next(std::deque<T> Filling::*decisions, const Copy& copy);
    template <class T>
    void write(const char* word, const T& decision);
    void begin(const std::vector<InputFact>& facts);
    void tell();

    std::filesystem::path path_;
    Listener& listener_;
    std::vector<Filling> fillings_;
    std::size_t filling_ = 0;  ///< from 1
    std::int64_t recalled_ = 0;
    std::unique_ptr<JournalFile> file_;
    bool told_of_file_ = false, told_of_failure_ = false;
};

}  // namespace spectralpack
