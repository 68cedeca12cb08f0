#include "spectralpack/names.hpp"

#include <gtest/gtest.h>

#include <set>

namespace spectralpack::test {
namespace {

/// Every word stands for one value, in the order of the values, and says it again.
template <Named Enum>
void expect_both_ways(std::initializer_list<Enum> values) {
    std::set<std::string_view> words;
    std::size_t position = 0;
    for (const Enum value : values) {
        const std::string_view word = to_string(value);
        ASSERT_FALSE(word.empty()) << position;
        EXPECT_TRUE(words.insert(word).second) << word << " stands for two values";
        EXPECT_EQ(from_string<Enum>(word), value) << word;
        EXPECT_EQ(words_of<Enum>()[position++], word);
    }
    EXPECT_EQ(words_of<Enum>().size(), values.size());
    EXPECT_FALSE(from_string<Enum>(""));
    EXPECT_FALSE(from_string<Enum>("no such word"));
}

TEST(Names, EveryEnumIsReadAsItIsWritten) {
    expect_both_ways({Interlock::off, Interlock::place, Interlock::post});
    expect_both_ways({Links::allow, Links::avoid});
    expect_both_ways({Unpack::any, Unpack::top});
    expect_both_ways({TakeOut::smallest, TakeOut::lightest, TakeOut::thinnest});
    expect_both_ways({Order::size, Order::input, Order::random, Order::volume, Order::mixed});
    expect_both_ways({EngineKind::automatic, EngineKind::cpu, EngineKind::cuda, EngineKind::reference});
    expect_both_ways({HeightReference::bottom, HeightReference::top});
    expect_both_ways({Minimise::none, Minimise::box});
    expect_both_ways({LengthUnit::mm, LengthUnit::inch, LengthUnit::m});
    expect_both_ways({ProgressStyle::automatic, ProgressStyle::bar, ProgressStyle::json, ProgressStyle::none});
    expect_both_ways({PartOrientations::Kind::any, PartOrientations::Kind::fixed, PartOrientations::Kind::upright});
    expect_both_ways({UnplacedReason::no_place, UnplacedReason::too_large, UnplacedReason::cannot_leave,
                      UnplacedReason::bad_file, UnplacedReason::not_tried, UnplacedReason::cap});
    expect_both_ways({FindingKind::outside, FindingKind::overlap, FindingKind::nested, FindingKind::gap,
                      FindingKind::transform, FindingKind::density, FindingKind::count, FindingKind::plan});
    expect_both_ways({Phase::load, Phase::voxelize, Phase::search, Phase::disassemble, Phase::reinsert, Phase::check,
                      Phase::render, Phase::write, Phase::improve});
    expect_both_ways(
        {Improves::height, Improves::density, Improves::copies, Improves::value, Improves::trays, Improves::box});
    expect_both_ways({Goal::fair, Goal::volume, Goal::copies, Goal::value});
    expect_both_ways({EventKind::tray_begun, EventKind::copy_placed, EventKind::copy_moved, EventKind::copy_taken_out,
                      EventKind::copy_put_back, EventKind::tray_finished});
    expect_both_ways({StopReason::none, StopReason::cancelled, StopReason::time_limit});
    expect_both_ways({ErrorKind::usage, ErrorKind::input, ErrorKind::resource, ErrorKind::internal});
}

/// Files and command lines of earlier versions hold these.
TEST(Names, TheWordsStay) {
    EXPECT_EQ(to_string(Interlock::post), "post");
    EXPECT_EQ(to_string(Links::avoid), "avoid");
    EXPECT_EQ(to_string(TakeOut::thinnest), "thinnest");
    EXPECT_EQ(to_string(Order::mixed), "mixed");
    EXPECT_EQ(to_string(EngineKind::automatic), "auto");
    EXPECT_EQ(to_string(HeightReference::top), "top");
    EXPECT_EQ(to_string(Minimise::box), "box");
    EXPECT_EQ(to_string(LengthUnit::inch), "inch");
    EXPECT_EQ(to_string(UnplacedReason::no_place), "no_place");
    EXPECT_EQ(to_string(FindingKind::nested), "nested");
    EXPECT_EQ(to_string(Phase::reinsert), "reinsert");
}

TEST(Names, AValueWithoutAWordHasNone) { EXPECT_EQ(to_string(PartOrientations::Kind::matrices), ""); }

}  // namespace
}  // namespace spectralpack::test
