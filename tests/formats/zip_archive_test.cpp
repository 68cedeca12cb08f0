#include "formats/zip_archive.hpp"

#include "files.hpp"

namespace spectralpack {
namespace {

std::string unpacked(const ZipReader& zip, const std::string& entry, std::uint64_t most = 1 << 20) {
    std::string text;
    zip.unpack(entry, most, [&](std::string_view piece) { text += piece; });
    return text;
}

TEST(ZipArchive, EntriesComeBackAndEqualOnesGiveEqualBytes) {
    const std::vector<ZipEntry> entries{{"a/b.txt", std::string(300'000, 'x')}, {"empty", ""}, {"ä", "ü"}};
    const std::string bytes = make_zip(entries);
    EXPECT_EQ(bytes, make_zip(entries));
    const ZipReader zip("f", bytes);
    for (const ZipEntry& entry : entries) {
        EXPECT_TRUE(zip.has(entry.name));
        EXPECT_EQ(unpacked(zip, entry.name), entry.content);
    }
    EXPECT_FALSE(zip.has("c"));
    EXPECT_EQ(test::refusal([&] { unpacked(zip, "c"); }).place(), "c");
}

TEST(ZipArchive, WhatUnpacksBeyondItsAllowanceIsCutOff) {
    const std::string bytes = make_zip({{"a", std::string(1'000'000, 'x')}});
    const ZipReader zip("f", bytes);
    std::size_t seen = 0;
    const InputError error =
        test::refusal([&] { zip.unpack("a", 100'000, [&](std::string_view piece) { seen += piece.size(); }); });
    EXPECT_TRUE(test::names(error.cause(), {100000}));
    EXPECT_LE(seen, 100'000u);
}

TEST(ZipArchive, DamageIsNoticed) {
    std::string text;
    for (int i = 0; i < 1000; ++i) {
        text += std::to_string(i * i);
    }
    const std::string whole = make_zip({{"a", text}});
    for (std::size_t at = 31; at < whole.size(); at += 7) {  // 31: after the header and the name
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
        try {
            const ZipReader zip("f", damaged);
            EXPECT_EQ(unpacked(zip, "a"), text) << at;  // some bytes of the directory are of no import
        } catch (const InputError&) {
        }
    }
    for (std::size_t length = 1; length < whole.size(); length += 11) {
        EXPECT_THROW(ZipReader("f", std::string_view(whole).substr(0, length)), InputError) << length;
    }
}

}  // namespace
}  // namespace spectralpack
