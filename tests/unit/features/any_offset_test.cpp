#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "analysis/document.h"
#include "features/code_actions.h"
#include "features/completion.h"
#include "features/signature_help.h"
#include "support/random_document.h"

namespace texbrdf::features {
namespace {

/// The document with a byte here and there replaced by one that hurts.
std::string damaged(std::string text, uint64_t seed) {
  constexpr std::string_view kBytes = "\\{}()[]_^%$&=,+ \n\xF0\x9D\x80";
  for (std::size_t i = seed % 7; i < text.size(); i += 11 + seed % 13) text[i] = kBytes[(i + seed) % kBytes.size()];
  return text;
}

constexpr std::string_view kMacros =
    "\\renewcommand{\\frac}[2]{{#1}/{#2}}\\renewcommand{\\kappa}{\\rho_s}\\renewcommand{\\max}[1][x]{\\min#1}"
    "\\renewcommand{\\vec}[1]{\\mathbf{#1}\\mathbf{#1}}\\renewcommand{\\sqrt}{\\sin{\\alpha}}\n";

TEST(TypingFeatures, AnswerAtEveryOffsetOfDamagedDocuments) {
  std::size_t proposals = 0;
  std::size_t signatures = 0;
  std::size_t actions = 0;
  for (uint64_t seed = 0; seed < 40; ++seed) {
    const std::string text = damaged(test::random_document(seed), seed);
    Document document(seed % 2 == 0 ? text : std::string(kMacros) + text);
    const Snapshot& snapshot = document.snapshot();
    NameIndex index;
    const uint32_t size = snapshot.text().size();
    for (uint32_t offset = 0; offset <= size; ++offset) {
      const Completions found = complete(snapshot, offset, index, {.snippets = true});
      proposals += found.items.size();
      if (found.in_math) {
        ASSERT_LE(found.replaced.begin, offset);
        ASSERT_GE(found.replaced.end, offset)
            << seed << ": " << snapshot.text().slice({offset < 60 ? 0 : offset - 60, offset});
        ASSERT_LE(found.replaced.end, size);
        ASSERT_EQ(snapshot.text().slice(found.replaced).find('\n'), std::string::npos);
      }
      if (const auto help = signature_help(snapshot, offset, Markup::Markdown)) ++signatures;
    }
    for (const CodeAction& action : code_actions(snapshot, {0, size})) {
      ++actions;
      for (const TextEdit& edit : action.edits) ASSERT_LE(edit.span.end, size);
    }
  }
  EXPECT_GT(proposals, 1000u);
  EXPECT_GT(signatures, 0u);
  EXPECT_GT(actions, 20u);
}

}  // namespace
}  // namespace texbrdf::features
