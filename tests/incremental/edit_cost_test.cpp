// What an edit costs does not depend on the document's size: counted in bytes allocated and in work done, which are the
// same on every machine. tests/bench/instructions_per_edit.py counts instructions.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <string>

#include "analysis/document.h"
#include "features/diagnostics.h"

namespace {

size_t allocated_bytes = 0;

}  // namespace

void* operator new(size_t size) {
  allocated_bytes += size;
  if (void* place = std::malloc(size == 0 ? 1 : size)) return place;
  throw std::bad_alloc();
}
void operator delete(void* place) noexcept {
  std::free(place);
}
void operator delete(void* place, size_t) noexcept {
  std::free(place);
}

namespace texbrdf {
namespace {

/// So many definitions, each of which mentions the one before.
std::string chain(int blocks) {
  std::string text = "\\begin{equation}\n  a_{0} = 0.5\n\\end{equation}\n";
  for (int i = 1; i < blocks; ++i) {
    text += "Term number " + std::to_string(i) + ".\n\\begin{equation}\n  a_{" + std::to_string(i) + "} = a_{" +
            std::to_string(i - 1) + "} * \\theta_h + 0.25\n\\end{equation}\n";
  }
  return text + "\\begin{equation}\n  f = a_{" + std::to_string(blocks - 1) + "}\n\\end{equation}\n";
}

struct Cost {
  size_t bytes = 0;
  Counters counters;
};

/// Of replacing what stands at the n-th "0.25", and of reading the diagnostics. The first edit also lists who mentions
/// what; the second is measured.
Cost cost_of_edit(int blocks, int place, const std::string& replacement) {
  std::string text = chain(blocks);
  Document document(text);
  document.prepare_for_edits();
  size_t at = 0;
  for (int i = 0; i <= place; ++i) at = text.find("0.25", at + 1);
  const auto offset = static_cast<uint32_t>(at);
  const auto edit = [&](const std::string& by) {
    document.replace({offset, offset + 4}, by);
    features::diagnostics(document.snapshot(), nullptr);
  };
  edit("0.75");
  const size_t before = allocated_bytes;
  edit(replacement);
  return {allocated_bytes - before, document.snapshot().counters()};
}

TEST(EditCost, AChangedDigitReadsAndChecksOneBlockOfTenThousand) {
  for (const int place : {0, 4999, 9998}) {
    const Counters counters = cost_of_edit(10'000, place, "0.35").counters;
    EXPECT_EQ(counters.blocks_scanned, 1u);
    EXPECT_EQ(counters.blocks_parsed, 1u);
    EXPECT_EQ(counters.definitions_checked, 1u);
  }
}

TEST(EditCost, AnotherNameReadsAndChecksOneBlockOfTenThousand) {
  const Counters counters = cost_of_edit(10'000, 5000, "a_{0}").counters;
  EXPECT_EQ(counters.blocks_parsed, 1u);
  EXPECT_EQ(counters.definitions_checked, 1u);
}

// A type that an error leaves known is no news to those who use it.
TEST(EditCost, AnErrorIsCheckedAndMendedWhereItIs) {
  struct Error {
    std::string equation;
    uint64_t checked;
  };
  const Error errors[] = {{"zq * \\theta_h + 0.25", 1},                  // an undefined name, and the chain is cut
                          {"a_{1} * zq + 0.25", 1},                      // on which the angle was all that there is
                          {"(a_{1} + \\vec{n}) * \\theta_h + 0.25", 1},  // types that do not fit
                          {"zq", 2},                                     // what it is cannot be said
                          {"(a_{1} * \\theta_h + 0.25", 2}};             // it cannot be read
  const std::string text = chain(10'000);
  for (const int block : {2, 5000, 9999}) {
    const std::string left = "a_{" + std::to_string(block) + "} = ";
    const std::string sound = "a_{" + std::to_string(block - 1) + "} * \\theta_h + 0.25";
    const auto begin = static_cast<uint32_t>(text.find(left) + left.size());
    for (const Error& error : errors) {
      Document document(text);
      document.prepare_for_edits();
      const auto checked_after = [&](const std::string& before, const std::string& after) {
        document.replace({begin, begin + static_cast<uint32_t>(before.size())}, after);
        return document.snapshot().counters().definitions_checked;
      };
      EXPECT_EQ(checked_after(sound, error.equation), error.checked) << error.equation << " in " << block;
      EXPECT_TRUE(document.snapshot().has_errors());
      EXPECT_EQ(checked_after(error.equation, sound), error.checked) << error.equation << " in " << block;
      EXPECT_FALSE(document.snapshot().has_errors());
    }
  }
}

TEST(EditCost, BytesAllocatedDoNotGrowWithTheDocument) {
  for (const std::string replacement : {"0.35", "a_{0}"}) {
    const size_t small = cost_of_edit(100, 50, replacement).bytes;
    for (const int place : {0, 4999, 9998}) {
      const size_t large = cost_of_edit(10'000, place, replacement).bytes;
      EXPECT_LE(large, 2 * small) << replacement << " at " << place;
    }
    RecordProperty("bytes for " + replacement, static_cast<int>(small));
  }
}

}  // namespace
}  // namespace texbrdf
