#pragma once
/// The options of `pack`, each once: name, values, range, default, help, and where the value is kept. Command line, job
/// files, packing files, docs/job.schema.json, docs/cli.md, man page and completions are made from this table. A
/// new option is its field in PackOptions, an entry in src/model/options, and its use.
///
///     PackOptions options;
///     set_option(options, "wall-gap", "1.5");              // as on the command line
///     for (const Option& option : option_table()) ...      // all of them, with their help

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "spectralpack/geometry.hpp"
#include "spectralpack/job_settings.hpp"
#include "spectralpack/options.hpp"

namespace spectralpack {

/// The headings of the help, in the order of a job.
enum class OptionGroup { parts, tray, gap, packing, result };

/// What an option takes, and what its OptionValue holds.
enum class OptionType {
    flag,       ///< bool; on the command line no value, and --no-NAME where `off_line` is said
    integer,    ///< std::int64_t
    natural,    ///< std::uint64_t
    bytes,      ///< std::int64_t; text with K, M, G, T (powers of 1000) or Ki, Mi, Gi, Ti (of 1024): "4G"
    number,     ///< double, finite
    size,       ///< Vec3, mm; text like 480x245x200, JSON [480, 245, 200]; without the height z is 0
    word,       ///< std::string, one of `words`
    rotations,  ///< std::string (orientations.hpp); in JSON also a number of degrees
    verify,     ///< std::string: an engine's word, or that and a number of placements: "reference:300"
    text,       ///< std::string
    file,       ///< std::string: a path; in a job file relative to it
    files,      ///< std::vector<std::string>: the same, repeatable
    folder,     ///< std::string: the same
};

/// std::monostate: none is said.
using OptionValue = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, Vec3, std::string,
                                 std::vector<std::string>>;

/// How the value is got from its field and put there. `set` takes what accepts() does.
template <class Settings>
struct OptionField {
    OptionValue (*get)(const Settings&) = nullptr;
    void (*set)(Settings&, const OptionValue&) = nullptr;
};

struct Option {
    std::string_view name;  ///< "wall-gap": --wall-gap on the command line
    char letter = 0;        ///< "-o"; 0: it has none
    OptionGroup group = OptionGroup::packing;
    int help_place = 0;  ///< from 1 on, among the twenty that --help shows; 0: only --help-all does
    OptionType type = OptionType::flag;
    double least = -std::numeric_limits<double>::infinity();  ///< of numbers
    double most = std::numeric_limits<double>::infinity();
    bool above = false;                            ///< `least` itself is too small
    std::span<const std::string_view> words = {};  ///< of type word: all; else values worth offering
    std::string_view none_word = {};               ///< that says none: "auto"
    std::string_view zero_word = {};               ///< that says 0: "all"
    std::string_view placeholder = {};             ///< for its value in help texts: "MM"
    std::string_view line = {};                    ///< help in one line
    std::string_view help = {};                    ///< more of it, in sentences; may be empty
    std::string_view off_line = {};                ///< what --no-NAME does
    std::string_view takes = {};                   ///< what values are, where the type does not say it
    std::string_view default_means = {};           ///< what the default comes to, where it does not say so itself
    std::vector<std::string_view> examples = {};   ///< as on the command line
    int hash_place = 0;  ///< from 1 on, among the options that the input hash covers; 0: placements do not depend on it
    bool optional = false;    ///< it may be none
    bool of_printer = false;  ///< a printer has a value of its own, which comes before the default
    /// Where the value is kept; at most one of them. In PackOptions: job files and packing files hold it. In
    /// JobSettings: job files do. Nowhere: only the command line knows it.
    OptionField<PackOptions> in_pack = {};
    OptionField<JobSettings> in_job = {};
};

/// In the order of packing files.
std::span<const Option> option_table();

/// By name, without dashes; null where there is none.
const Option* find_option(std::string_view name);

std::string_view title_of(OptionGroup group);
inline constexpr OptionGroup kOptionGroups[] = {OptionGroup::parts, OptionGroup::tray, OptionGroup::gap,
                                                OptionGroup::packing, OptionGroup::result};

/// Those under a heading: first what --help shows, in its order, then the others in the table's.
std::vector<const Option*> options_under(OptionGroup group);

/// That of default PackOptions and JobSettings.
OptionValue default_of(const Option& option);

/// The default for people: "0.2", "0: all"; empty for flags that are off, and for none.
std::string default_text(const Option& option);

/// The same in a word or two: "0", "the printer's, else 0.2".
std::string short_default_text(const Option& option);

/// What it takes, for people: "a number above 0", "one of off, place, post".
std::string values_of(const Option& option);

/// The value is of the option's type, in its range, and one of its words.
bool accepts(const Option& option, const OptionValue& value);

/// Throws UsageError naming option, value and what it takes, where it does not accept() the value.
void require_accepted(const Option& option, const OptionValue& value);

/// From text as on the command line, and back (empty for none). Throws UsageError naming the option.
OptionValue parse_value(const Option& option, std::string_view text);
std::string text_of(const Option& option, const OptionValue& value);

/// Sets the option from such text. Throws UsageError, also for options that PackOptions do not hold.
void set_option(PackOptions& options, std::string_view name, std::string_view text);

/// "480x245x200"; two sides will do, z is 0 then. None for anything else, and where a side is not above 0.
std::optional<Vec3> parse_size(std::string_view text);

}  // namespace spectralpack
