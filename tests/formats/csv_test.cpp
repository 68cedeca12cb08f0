#include "formats/csv.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "spectralpack/error.hpp"

namespace spectralpack {
namespace {

using Fields = std::vector<std::string>;

TEST(Csv, QuotedFieldsHoldCommasQuotesAndLineEnds) {
    const auto rows = parse_csv("f", "a,\"b,c\",\"d \"\"e\"\"\"\r\n\"two\nlines\",,x\n");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0].fields, (Fields{"a", "b,c", "d \"e\""}));
    EXPECT_EQ(rows[1].fields, (Fields{"two\nlines", "", "x"}));
    EXPECT_EQ(rows[1].line, 2);
}

TEST(Csv, BlankLinesAndAByteOrderMarkAreSkippedAndLinesStayCounted) {
    const auto rows = parse_csv("f", "\xef\xbb\xbfh\n\n\r\n\"a\nb\"\rlast");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_EQ(rows[0].fields, Fields{"h"});
    EXPECT_EQ(rows[1].line, 4);
    EXPECT_EQ(rows[2].fields, Fields{"last"});
    EXPECT_EQ(rows[2].line, 6);
}

TEST(Csv, MisplacedQuotesAreRefusedWithTheLine) {
    for (const char* text : {"ok\na\"b\n", "ok\n\"open", "ok\n\"a\"b\n"}) {
        try {
            parse_csv("list.csv", text);
            ADD_FAILURE() << text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.file(), "list.csv");
            EXPECT_EQ(error.place(), "line 2") << text;
        }
    }
}

TEST(Csv, AnyFieldsReadBackAsTheyWereWritten) {
    EXPECT_TRUE(rc::check([](const std::vector<Fields>& table) {
        std::string text;
        std::vector<Fields> expected;
        for (const Fields& row : table) {
            if (row.empty() || row == Fields{""}) continue;  // a blank line is no row
            for (std::size_t i = 0; i < row.size(); ++i) {
                text += (i ? "," : "") + csv_field(row[i]);
            }
            text += "\r\n";
            expected.push_back(row);
        }
        std::vector<Fields> read;
        for (const CsvRow& row : parse_csv("f", text)) {
            read.push_back(row.fields);
        }
        RC_ASSERT(read == expected);
    }));
}

}  // namespace
}  // namespace spectralpack
