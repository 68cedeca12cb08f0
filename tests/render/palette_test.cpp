#include "render/palette.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <array>
#include <set>

namespace spectralpack {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

Rgb shown(const Vec3& c) { return {to_srgb(c.x), to_srgb(c.y), to_srgb(c.z)}; }

TEST(Palette, WithoutChromaIsGrey) {
    for (const double lightness : {0.0, 0.25, 0.5, 1.0}) {
        const Vec3 grey = from_oklch(lightness, 0, 123);
        // The published matrices have ten digits; a grey's intensity is the cube of its lightness.
        EXPECT_NEAR(grey.x, lightness * lightness * lightness, 1e-6);
        EXPECT_NEAR(grey.y, grey.x, 1e-6);
        EXPECT_NEAR(grey.z, grey.x, 1e-6);
    }
}

TEST(Palette, IsInGamutForAnyColour) {
    EXPECT_TRUE(rc::check([](std::uint16_t l, std::uint16_t c, std::uint16_t h) {
        const Vec3 colour = from_oklch(l / 65535.0, c / 65535.0, h);
        for (int i = 0; i < 3; ++i) {
            RC_ASSERT(colour[i] >= 0 && colour[i] <= 1);
        }
    }));
}

TEST(Palette, EncodesAllBytesInOrder) {
    EXPECT_EQ(to_srgb(-1), 0);
    EXPECT_EQ(to_srgb(0), 0);
    EXPECT_EQ(to_srgb(1), 255);
    EXPECT_EQ(to_srgb(7), 255);
    EXPECT_EQ(to_srgb(0.2158605),
              128);  // IEC 61966-2-1 backwards: ((128/255 + 0.055) / 1.055) ^ 2.4
    std::set<int> bytes;
    int last = 0;
    for (int i = 0; i <= 20000; ++i) {
        const int byte = to_srgb(i / 20000.0);
        EXPECT_GE(byte, last);
        bytes.insert(last = byte);
    }
    EXPECT_EQ(bytes.size(), 256u);
}

TEST(Palette, GivesEachCopyItsOwnColour) {
    for (const int parts : {1, 5, 40}) {
        std::set<Rgb> colours;
        int copies = 0;
        for (int part = 0; part < parts; ++part) {
            for (int copy = 0; copy < 300 / parts; ++copy, ++copies) {
                colours.insert(shown(copy_colour(part, copy, parts)));
            }
        }
        // Two of several hundred may round to the same bytes.
        EXPECT_GE(static_cast<int>(colours.size()), copies - copies / 50) << parts;
    }
}

TEST(Palette, KeepsCopiesOfAPartCloserThanParts) {
    const auto off = [](const Vec3& a, const Vec3& b) { return length(a - b); };
    for (int part = 0; part < 8; ++part) {
        Vec3 mean;
        for (int copy = 0; copy < 50; ++copy) {
            mean = mean + 0.02 * copy_colour(part, copy, 8);
        }
        for (int other = 0; other < 8; ++other) {
            if (other == part) continue;
            int nearer = 0;
            for (int copy = 0; copy < 50; ++copy) {
                Vec3 there;
                for (int k = 0; k < 50; ++k) {
                    there = there + 0.02 * copy_colour(other, k, 8);
                }
                const Vec3 colour = copy_colour(part, copy, 8);
                if (off(colour, mean) < off(colour, there)) ++nearer;
            }
            EXPECT_GE(nearer, 40) << part << " and " << other;
        }
    }
}

}  // namespace
}  // namespace spectralpack
