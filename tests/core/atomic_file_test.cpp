#include "core/atomic_file.hpp"

#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>

#include "spectralpack/error.hpp"
#include "support/names.hpp"
#include "support/process.hpp"

namespace spectralpack {
namespace {

std::ptrdiff_t files_in(const std::filesystem::path& folder) {
    return std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator());
}

TEST(ReplaceFile, ReplacesAnExistingFileWhole) {
    const test::TemporaryFolder folder;
    replace_file(folder / "a.txt", "old and long");
    replace_file(folder / "a.txt", "new");
    EXPECT_EQ(test::read_text(folder / "a.txt"), "new");
    EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(ReplaceFile, AFailureKeepsTheOldFileAndLeavesNothingBehind) {
    const test::TemporaryFolder folder;
    replace_file(folder / "a.txt", "old");
    EXPECT_THROW(replace_file(folder / "a.txt",
                              [](const std::filesystem::path& temporary) {
                                  std::ofstream(temporary) << "half";
                                  throw ResourceError("the disk is full");
                              }),
                 ResourceError);
    EXPECT_EQ(test::read_text(folder / "a.txt"), "old");
    EXPECT_EQ(files_in(folder.path()), 1);
}

TEST(ReplaceFile, KeepsTheEndingForWritersThatChooseByIt) {
    const test::TemporaryFolder folder;
    replace_file(folder / "a.3mf", [](const std::filesystem::path& temporary) {
        EXPECT_EQ(temporary.extension(), ".3mf");
        std::ofstream(temporary) << "x";
    });
    EXPECT_TRUE(std::filesystem::exists(folder / "a.3mf"));
}

TEST(ReplaceFile, TakesNamesAsLongAsTheFileSystemDoes) {
    const test::TemporaryFolder folder;
    std::string characters;  // of two bytes each
    for (int i = 0; i < 125; ++i) {
        characters += "\xc3\xa9";
    }
    for (const std::string& stem : {std::string(250, 'a'), characters}) {
        const std::filesystem::path path = folder / (stem + ".json"), temporary = temporary_file(path);
        const std::string name = temporary.filename().string();
        EXPECT_LE(name.size(), 255u);
        EXPECT_EQ(name.find("\xc3."), std::string::npos) << "a character is cut in two";
        replace_file(path, "x");
        EXPECT_EQ(test::read_text(path), "x");
    }
    EXPECT_EQ(temporary_file("build.3mf").extension(), ".3mf");
}

TEST(ReplaceFile, RemovesWhatKilledProcessesLeftOfTheSameFile) {
    const test::TemporaryFolder folder;
    const pid_t gone = fork();
    if (gone == 0) _exit(0);
    int status = 0;
    ASSERT_EQ(waitpid(gone, &status, 0), gone);
    const std::string killed = std::to_string(gone), alive = std::to_string(getppid());
    const std::vector<std::string> kept{".b.part" + killed + ".txt",
                                        ".a.part" + killed + ".json",
                                        ".a.part" + alive + ".txt",
                                        ".a.part.txt",
                                        ".a.part12x.txt",
                                        "a.part" + killed + ".txt"};
    for (const std::string& name : kept) {
        std::ofstream(folder / name) << "x";
    }
    std::ofstream(folder / (".a.part" + killed + ".txt")) << "half";
    replace_file(folder / "a.txt", "new");
    for (const std::string& name : kept) {
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    }
    EXPECT_EQ(files_in(folder.path()), std::ssize(kept) + 1);
}

TEST(ReplaceFile, AMissingFolderIsNamed) {
    const test::TemporaryFolder folder;
    try {
        replace_file(folder / "no/a.txt", "x");
        FAIL();
    } catch (const ResourceError& error) {
        EXPECT_TRUE(test::names(error.what(), {(folder / "no").string()}));
    }
}

TEST(ReplaceFile, TheReasonOfAFailureIsTold) {
    const test::TemporaryFolder folder;
    const std::filesystem::path too_long = folder / std::string(300, 'a');
    try {
        replace_file(too_long, "x");
        FAIL();
    } catch (const ResourceError& error) {
        EXPECT_TRUE(test::names(error.what(), {too_long.string(), std::strerror(ENAMETOOLONG)}));
    }
}

}  // namespace
}  // namespace spectralpack
