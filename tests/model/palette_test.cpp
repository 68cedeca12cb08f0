#include "model/palette.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

namespace spectralpack {
namespace {

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

TEST(Palette, IsTheOneOfTheDesign) {
    EXPECT_EQ(part_colour_text(0), "#69a3cb");
    EXPECT_EQ(part_colour_text(15), "#7d8792");
    const Vec3 first = part_colour(0), again = part_colour(16);
    EXPECT_LT(again.y, first.y);  // darker
    EXPECT_NE(part_colour_text(16), part_colour_text(0));
}

TEST(Palette, KeepsCopiesOfAPartCloserThanParts) {
    for (int part = 0; part < 16; ++part) {
        for (int copy = 0; copy < 50; ++copy) {
            const Vec3 colour = copy_colour(part, copy);
            for (int other = 0; other < 16; ++other) {
                if (other == part) continue;
                EXPECT_LT(length(colour - part_colour(part)), length(colour - part_colour(other)))
                    << part << " copy " << copy << " and " << other;
            }
        }
    }
}

}  // namespace
}  // namespace spectralpack
