/// Packings of all modes, judged by a second verifier that shares no code with the program (second_check.cpp). It needs
/// CGAL; without it these say that they are skipped. Labelled `long`; scripts/attack.sh asks it about random jobs.

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "cli/program.hpp"

namespace spectralpack::test {
namespace {

using nlohmann::json;

class SecondCheck : public testing::Test {
  protected:
    void SetUp() override {
#ifndef SECOND_CHECK
        GTEST_SKIP() << "skipped: built without CGAL (libcgal-dev)";
#endif
    }

    /// Its verdict; its exit status must be this one.
    json verdict(int status) const {
#ifdef SECOND_CHECK
        const Ran ran = run({SECOND_CHECK, file_});
        EXPECT_EQ(ran.status, status) << ran.out << ran.err;
        return json::parse(ran.out, nullptr, false);
#else
        return status;
#endif
    }

    void pack(const std::vector<std::string>& options) const {
        std::vector<std::string> parts;  // STL files are what it reads
        for (const auto& entry : std::filesystem::directory_iterator(samples())) {
            if (entry.path().extension() == ".stl") parts.push_back(entry.path().string() + ":3");
        }
        std::ranges::sort(parts);
        const Ran ran = spectralpack(std::vector<std::string>{"pack", "-o", file_} + parts + options);
        ASSERT_EQ(ran.status, 0) << ran.err;
    }
    void write(const json& packing) const { std::ofstream(file_) << packing; }

    void expect_sound(const std::vector<std::string>& options) const {
        pack(options);
        const json found = verdict(0);
        const json packing = read_json(file_);
        std::size_t copies = 0, steps = 0;
        for (const json& tray : packing["trays"]) {
            copies += tray["placements"].size();
            if (!tray["disassembly"].is_null()) steps += tray["disassembly"]["steps"].size();
        }
        EXPECT_GT(copies, 10U);
        EXPECT_EQ(found["copies"], copies);
        EXPECT_EQ(found["steps"], steps);
    }

    TemporaryFolder folder_;
    std::string file_ = (folder_ / "packing.json").string();
};

TEST_F(SecondCheck, OfASmallTray) { expect_sound(kSmall); }
TEST_F(SecondCheck, OfAFineTray) { expect_sound({"--tray", "120x110x90", "--voxel", "1", "--gap", "1"}); }
TEST_F(SecondCheck, OfTouchingCopies) { expect_sound(kSmall + std::vector<std::string>{"--gap", "0"}); }
TEST_F(SecondCheck, OnTheGrid) { expect_sound(kSmall + std::vector<std::string>{"--no-refine", "--wall-gap", "1"}); }
TEST_F(SecondCheck, OfSeveralTrays) { expect_sound(kSmall + std::vector<std::string>{"--trays", "2"}); }
TEST_F(SecondCheck, WithoutACeiling) { expect_sound({"--tray", "110x85", "--voxel", "3", "--open-height"}); }
TEST_F(SecondCheck, AroundAKeepOut) {
    expect_sound(kSmall + std::vector<std::string>{"--keep-out", "40,0,0,50,60,50", "--physical"});
}
TEST_F(SecondCheck, OfPlansThroughWalls) { expect_sound(kSmall + std::vector<std::string>{"--unpack", "any"}); }

// What is wrong is found: each moves or changes one thing of a sound packing.

class SecondCheckFinds : public SecondCheck {
  protected:
    void SetUp() override {
        SecondCheck::SetUp();
        if (IsSkipped()) return;
        pack(kSmall);
        packing_ = read_json(file_);
    }
    json& placements() { return packing_["trays"][0]["placements"]; }
    json& placement(std::size_t i) { return placements()[i]; }
    void move(std::size_t i, int axis, double by) {
        double& place = placement(i)["transform"][static_cast<std::size_t>(axis)][3].get_ref<double&>();
        place += by;
    }
    /// Something is found that names this.
    void expect_found(const std::string& what) {
        write(packing_);
        const json found = verdict(1);
        EXPECT_NE(found["findings"].dump().find(what), std::string::npos) << found.dump(1);
    }

    json packing_;
};

TEST_F(SecondCheckFinds, CopiesInOnePlace) {
    // Two of one part and one orientation, exactly in each other: no surfaces cross.
    for (std::size_t i = 1; i < placements().size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            if (placement(i)["part"] != placement(k)["part"]) continue;
            placement(i)["transform"] = placement(k)["transform"];
            return expect_found("lie in each other");
        }
    }
    FAIL() << "no part is there twice";
}

TEST_F(SecondCheckFinds, WhatCheckFinds) {
    packing_["trays"][0]["disassembly"] = nullptr;
    const json sound = packing_;
    int found = 0;
    for (std::size_t i = 0; i < 24; ++i) {
        packing_ = sound;
        move(i % placements().size(), static_cast<int>(i % 3), i % 2 ? 3 : -3);
        write(packing_);
        const int status = spectralpack({"check", file_}).status;
        EXPECT_EQ(verdict(status)["ok"], status == 0) << "placement " << i;
        found += status;
    }
    EXPECT_GT(found, 10);
}

TEST_F(SecondCheckFinds, ALargerGap) {
    for (json& part : packing_["parts"]) {
        part["gap"] = 0.5;
    }
    expect_found("not 0.5");
}

TEST_F(SecondCheckFinds, ACopyOutsideTheTray) {
    move(0, 2, 60);
    expect_found("out of the tray");
}

TEST_F(SecondCheckFinds, AStretchedCopy) {
    double& x = placement(0)["transform"][0][0].get_ref<double&>();
    x += 0.01;
    expect_found("turned and scaled");
}

TEST_F(SecondCheckFinds, ACopyThatIsThereTwice) {
    placement(1)["part"] = placement(0)["part"];
    placement(1)["copy"] = placement(0)["copy"];
    expect_found("twice");
}

TEST_F(SecondCheckFinds, AnotherDensity) {
    packing_["trays"][0]["density"] = packing_["trays"][0]["density"].get<double>() + 0.001;
    expect_found("density");
}

TEST_F(SecondCheckFinds, APlanThatIsTurnedRound) {
    json& steps = packing_["trays"][0]["disassembly"]["steps"];
    std::reverse(steps.begin(), steps.end());
    expect_found("runs into");
}

TEST_F(SecondCheckFinds, AStepThatEndsTooEarly) {
    for (json& step : packing_["trays"][0]["disassembly"]["steps"]) {
        for (json& way : step["path"]) {
            for (json& length : way) {
                length = length.get<double>() / 4;
            }
        }
    }
    expect_found("does not end");
}

TEST_F(SecondCheckFinds, APlanWithoutACopy) {
    json& steps = packing_["trays"][0]["disassembly"]["steps"];
    steps.erase(steps.size() - 1);
    expect_found("complete without");
}

}  // namespace
}  // namespace spectralpack::test
