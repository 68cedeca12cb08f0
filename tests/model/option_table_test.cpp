#include "spectralpack/option_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "spectralpack/error.hpp"

namespace spectralpack::test {
namespace {

const Option& option(std::string_view name) {
    const Option* found = find_option(name);
    if (!found) throw UsageError("no option " + std::string(name));
    return *found;
}

/// What the refusal says; empty where the text is taken.
std::string refusal_of(const Option& option, const std::string& text) {
    try {
        parse_value(option, text);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(OptionTable, EveryEntryIsComplete) {
    std::set<std::string_view> names;
    std::set<int> places;
    for (const Option& o : option_table()) {
        SCOPED_TRACE(std::string(o.name));
        EXPECT_TRUE(names.insert(o.name).second);
        EXPECT_EQ(find_option(o.name), &o);
        EXPECT_FALSE(o.line.empty());
        EXPECT_FALSE(o.line.ends_with('.'));
        EXPECT_TRUE(o.help.empty() || o.help.ends_with('.'));
        EXPECT_EQ(o.placeholder.empty(), o.type == OptionType::flag);
        EXPECT_EQ(o.examples.empty(), o.type == OptionType::flag);
        EXPECT_FALSE(o.type == OptionType::word && o.words.empty());
        EXPECT_FALSE(o.in_pack.get && o.in_job.get);
        if (o.hash_place > 0) {
            EXPECT_TRUE(o.in_pack.get);
            EXPECT_TRUE(places.insert(o.hash_place).second);
        }
    }
    ASSERT_FALSE(places.empty());
    EXPECT_EQ(*places.begin(), 1);
    EXPECT_EQ(*places.rbegin(), static_cast<int>(places.size()));
}

TEST(OptionTable, DefaultsAreThoseOfTheStructs) {
    const PackOptions defaults;
    EXPECT_EQ(default_of(option("tray")), OptionValue(defaults.tray));
    EXPECT_EQ(default_of(option("gap")), OptionValue(defaults.gap));
    EXPECT_EQ(default_of(option("voxel")), OptionValue());
    EXPECT_EQ(default_of(option("refine")), OptionValue(defaults.refine));
    EXPECT_EQ(default_of(option("order")), OptionValue(std::string("size")));
    EXPECT_EQ(default_of(option("height-penalty")), OptionValue());
    for (const Option& o : option_table()) {
        const OptionValue value = default_of(o);
        const bool kept = o.in_pack.get || o.in_job.get;
        EXPECT_TRUE(!kept || accepts(o, value)) << o.name;
        const std::string text = text_of(o, value);
        if (!text.empty()) {
            EXPECT_EQ(parse_value(o, text), value) << o.name;
        }
    }
    EXPECT_EQ(default_text(option("gap")), "the printer's, else 0.2");
    EXPECT_EQ(short_default_text(option("threads")), "all");
    EXPECT_EQ(short_default_text(option("voxel")), "2");
    EXPECT_EQ(default_text(option("threads")), "0: all");
    EXPECT_EQ(default_text(option("ray-spacing")), "4 voxel / detail");
    EXPECT_EQ(default_text(option("fill")), "");
}

TEST(OptionTable, TextBecomesTheFieldAndTheFieldThatText) {
    for (const Option& o : option_table()) {
        if (!o.in_pack.get) continue;
        std::vector<std::string> texts(o.examples.begin(), o.examples.end());
        if (o.type == OptionType::flag) texts = {"true", "false"};
        if (o.type == OptionType::word) texts.assign(o.words.begin(), o.words.end());
        if (!o.none_word.empty()) texts.emplace_back(o.none_word);
        for (const std::string& text : texts) {
            SCOPED_TRACE(std::string(o.name) + " " + text);
            PackOptions options;
            set_option(options, o.name, text);
            EXPECT_EQ(o.in_pack.get(options), parse_value(o, text));
            PackOptions again;
            set_option(again, o.name, text_of(o, o.in_pack.get(options)));
            EXPECT_EQ(o.in_pack.get(again), o.in_pack.get(options));
            for (const Option& other : option_table()) {
                if (!other.in_pack.get || &other == &o) continue;
                EXPECT_EQ(other.in_pack.get(options), default_of(other)) << "changes with it";
            }
        }
    }
}

TEST(OptionTable, TextMeansWhatItSays) {
    PackOptions o;
    set_option(o, "tray", "160x120.5X100");
    EXPECT_EQ(o.tray, (Vec3{160, 120.5, 100}));
    set_option(o, "tray", "300x200");
    EXPECT_EQ(o.tray, (Vec3{300, 200, 0}));
    set_option(o, "trays", "all");
    EXPECT_EQ(o.trays, 0);
    set_option(o, "memory", "4G");
    EXPECT_EQ(o.memory, 4'000'000'000);
    set_option(o, "memory", "2KiB");
    EXPECT_EQ(o.memory, 2048);
    set_option(o, "seed", "18446744073709551615");
    EXPECT_EQ(o.seed, 18446744073709551615u);
    set_option(o, "verify-with", "reference:300");
    EXPECT_EQ(o.verify_with, (VerifyWith{EngineKind::reference, 300}));
    set_option(o, "verify-with", "reference");
    EXPECT_EQ(o.verify_with, (VerifyWith{EngineKind::reference, 0}));
    set_option(o, "height-penalty", "1e8");
    EXPECT_EQ(o.height_penalty, 1e8);
    set_option(o, "height-penalty", "auto");
    EXPECT_FALSE(o.height_penalty);
    set_option(o, "height-at", "top");
    EXPECT_EQ(o.height_at, HeightReference::top);
    set_option(o, "gap", "+1.5");
    EXPECT_EQ(o.gap, 1.5);
    EXPECT_THROW(set_option(o, "output", "a.json"), UsageError) << "PackOptions have no such field";
    EXPECT_THROW(set_option(o, "gaps", "1"), UsageError);
}

TEST(OptionTable, RefusalsNameTheOptionAndWhatWasSaid) {
    const std::pair<const char*, std::vector<const char*>> wrong[] = {
        {"tray", {"", "480", "0x1x1", "1x1x0", "nanx1x1", "1x2x3x4", "1x2x", "-1x2x3", "1x1xinf"}},
        {"trays", {"0", "-1", "few", "1.5", "3000000000"}},
        {"try-per-tray", {"-1", "some"}},
        {"voxel", {"0", "-1", "nan", "inf", "2mm", ""}},
        {"detail", {"0", "9", "1.5"}},
        {"rotations", {"17", "5", "lots", "icosahedron:4", "icosahedron:-1", "90+"}},
        {"gap", {"-0.5", "nan"}},
        {"interlock", {"never", "POST", ""}},
        {"ray-spacing", {"0", "auto"}},
        {"height-penalty", {"4x", "-1"}},
        {"height-at", {"middle"}},
        {"max-density", {"0", "1.01", "40"}},
        {"order", {"best"}},
        {"restarts", {"0", "1000001"}},
        {"beam", {"0", "101"}},
        {"seed", {"-1", "18446744073709551616"}},
        {"memory", {"lots", "-1", "1X", "1Gi i"}},
        {"verify-with", {"reference:0", "reference:", "reference:x", "someone"}},
        {"time-limit", {"-1"}},
        {"unit", {"cubit"}},
        {"material-density", {"0"}},
        {"report", {""}},
        {"progress", {"loud"}}};
    for (const auto& [name, texts] : wrong) {
        for (const char* text : texts) {
            const std::string said = refusal_of(option(name), text);
            EXPECT_TRUE(contains(said, std::string("--") + name)) << name << " " << text << ": " << said;
            EXPECT_TRUE(contains(said, std::string("'") + text + "'")) << said;
        }
    }
}

TEST(OptionTable, ARefusalNamesTheRange) {
    const std::string detail = refusal_of(option("detail"), "9");
    EXPECT_TRUE(contains(detail, "1") && contains(detail, "8")) << detail;
    const std::string order = refusal_of(option("order"), "best");
    for (const std::string_view word : option("order").words) {
        EXPECT_TRUE(contains(order, std::string(word))) << order;
    }
    EXPECT_TRUE(contains(refusal_of(option("trays"), "0"), "all"));
}

TEST(OptionTable, NumbersAreTakenUpToTheirBoundsAndNoFurther) {
    for (const Option& o : option_table()) {
        const bool whole = o.type == OptionType::integer || o.type == OptionType::bytes;
        if (!whole && o.type != OptionType::number) continue;
        SCOPED_TRACE(std::string(o.name));
        const auto value = [&](double number) {
            return whole ? OptionValue(static_cast<std::int64_t>(number)) : OptionValue(number);
        };
        const double step = whole ? 1 : 1e-9;
        if (std::isfinite(o.least)) {
            EXPECT_EQ(accepts(o, value(o.least)), !o.above);
            EXPECT_TRUE(accepts(o, value(o.least + step)));
            EXPECT_EQ(accepts(o, value(o.least - step)), o.least - step == 0 && !o.zero_word.empty());
        }
        if (std::isfinite(o.most)) {
            EXPECT_TRUE(accepts(o, value(o.most)));
            EXPECT_FALSE(accepts(o, value(o.most + step)));
        }
        EXPECT_FALSE(accepts(o, std::string("1")));
        EXPECT_EQ(accepts(o, OptionValue()), o.optional);
        EXPECT_THROW(require_accepted(o, std::string("1")), UsageError);
    }
}

}  // namespace
}  // namespace spectralpack::test
