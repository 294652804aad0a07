#include "source/source_text.h"

#include <gtest/gtest.h>

#include "source/utf8.h"
#include "support/random.h"

namespace texbrdf {
namespace {

TEST(SourceText, ends_lines_at_line_feed_carriage_return_and_both) {
  const SourceText text("a\nb\r\nc\rd\r\r\n\n");
  ASSERT_EQ(text.line_count(), 7u);
  EXPECT_EQ(text.line(0), "a");
  EXPECT_EQ(text.line(1), "b");
  EXPECT_EQ(text.line(2), "c");
  EXPECT_EQ(text.line(3), "d");
  EXPECT_EQ(text.line(4), "");
  EXPECT_EQ(text.line(5), "");
  EXPECT_EQ(text.line(6), "");
  EXPECT_EQ(text.line(7), "");
}

TEST(SourceText, counts_columns_in_the_three_units) {
  // ω: 2 bytes, 1 unit; 𝑓: 4 bytes, 2 units.
  const SourceText text("x\nω𝑓=1");
  const uint32_t equals = 2 + 2 + 4;
  EXPECT_EQ(text.position(equals, ColumnUnit::Utf8), (Position{1, 6}));
  EXPECT_EQ(text.position(equals, ColumnUnit::Utf16), (Position{1, 3}));
  EXPECT_EQ(text.position(equals, ColumnUnit::CodePoint), (Position{1, 2}));
  EXPECT_EQ(text.offset({1, 6}, ColumnUnit::Utf8), equals);
  EXPECT_EQ(text.offset({1, 3}, ColumnUnit::Utf16), equals);
  EXPECT_EQ(text.offset({1, 2}, ColumnUnit::CodePoint), equals);
}

TEST(SourceText, takes_a_column_inside_a_code_point_for_its_start) {
  const SourceText text("𝑓=");
  EXPECT_EQ(text.offset({0, 1}, ColumnUnit::Utf16), 0u);
  EXPECT_EQ(text.offset({0, 3}, ColumnUnit::Utf8), 0u);
  EXPECT_EQ(text.position(2, ColumnUnit::Utf16), (Position{0, 0}));
}

TEST(SourceText, takes_places_beyond_a_line_or_the_document_for_the_end) {
  const SourceText text("ab\r\ncd");
  EXPECT_EQ(text.offset({0, 99}, ColumnUnit::Utf16), 2u);
  EXPECT_EQ(text.offset({9, 0}, ColumnUnit::Utf16), 6u);
  EXPECT_EQ(text.position(99, ColumnUnit::Utf8), (Position{1, 2}));
  EXPECT_EQ(text.position(3, ColumnUnit::Utf8), (Position{0, 2}));
  EXPECT_EQ(text.slice({4, 99}), "cd");
  EXPECT_EQ(text.slice({99, 3}), "");
}

TEST(SourceText, counts_a_byte_that_is_not_utf8_as_one_code_point) {
  const SourceText text("\xFF\xC3(\xE2\x82");
  EXPECT_EQ(text.position(5, ColumnUnit::CodePoint), (Position{0, 5}));
  EXPECT_EQ(text.position(2, ColumnUnit::Utf16), (Position{0, 2}));
}

TEST(SourceText, finds_every_code_point_of_any_bytes_again) {
  test::Random random(1);
  for (int round = 0; round < 300; ++round) {
    std::string bytes;
    constexpr std::string_view kPieces[] = {"a",    "\n",       "\r",       "\r\n",         "ω", "𝑓",
                                            "\xFF", "\xE2\x82", "\xF0\x9D", "\xED\xA0\x80", " "};
    for (int i = 0; i < 40; ++i) bytes += kPieces[random.below(std::size(kPieces))];
    const SourceText text(bytes);
    for (const ColumnUnit unit : {ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::CodePoint}) {
      for (uint32_t line = 0; line < text.line_count(); ++line) {
        uint32_t offset = text.line_start(line);
        const std::string content = text.line(line);
        for (std::string_view rest = content; !rest.empty();) {
          EXPECT_EQ(text.offset(text.position(offset, unit), unit), offset);
          const uint32_t size = code_point_at_front(rest).size;
          rest.remove_prefix(size);
          offset += size;
        }
      }
    }
  }
}

TEST(Utf8, shows_what_cannot_be_shown_as_replacement_characters) {
  EXPECT_EQ(printable("a\x1b[31m\tω\xFF\u202E", "  "), "a\uFFFD[31m  ω\uFFFD\uFFFD");
  EXPECT_EQ(count_code_points("aω\xFF𝑓"), 4u);
}

}  // namespace
}  // namespace texbrdf
