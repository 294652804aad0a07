#include "lsp/positions.h"

#include <gtest/gtest.h>

#include <string>

namespace texbrdf::lsp {
namespace {

constexpr ColumnUnit kUnits[] = {ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::CodePoint};

/// In any order of questions the answer is that of the text itself.
void expect_same_as_text(const std::string& bytes) {
  const SourceText text(bytes);
  for (const ColumnUnit unit : kUnits) {
    Positions forward(text, unit);
    Positions backward(text, unit);
    for (uint32_t offset = 0; offset <= text.size() + 1; ++offset) {
      ASSERT_EQ(forward.at(offset), text.position(offset, unit)) << "offset " << offset;
      const uint32_t other = text.size() + 1 - offset;
      ASSERT_EQ(backward.at(other), text.position(other, unit)) << "offset " << other;
    }
  }
}

TEST(Positions, AgreeWithTheTextOnShortLines) {
  expect_same_as_text("a\n😀b ℝ³\r\n\r\xff\xfe c\n");
  expect_same_as_text("");
}

TEST(Positions, AgreeWithTheTextOnLongLines) {
  std::string line;
  for (int i = 0; i < 700; ++i) line += i % 7 == 0 ? "😀" : i % 5 == 0 ? "ℝ" : i % 11 == 0 ? "\xff" : "abc";
  expect_same_as_text("first\n" + line + "\r\n" + line + "\nlast");
}

TEST(Positions, ManyPlacesOnOneLineAreCheap) {
  std::string line;
  for (int i = 0; i < 50000; ++i) line += "😀";
  const SourceText text(line);
  Positions positions(text, ColumnUnit::Utf16);
  uint64_t sum = 0;
  for (uint32_t offset = 0; offset < text.size(); offset += 4) sum += positions.at(offset).column;
  EXPECT_EQ(sum, uint64_t{49999} * 50000);
}

}  // namespace
}  // namespace texbrdf::lsp
