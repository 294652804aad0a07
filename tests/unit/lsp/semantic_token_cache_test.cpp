#include "lsp/semantic_token_cache.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "lsp/positions.h"
#include "support/random.h"
#include "support/random_document.h"

namespace texbrdf::lsp {
namespace {

using Numbers = std::vector<uint32_t>;

Numbers numbers(const std::string& json) {
  return nlohmann::json::parse(json).get<Numbers>();
}

/// What a client does.
Numbers applied(const Numbers& before, const std::vector<SemanticTokenCache::Edit>& edits) {
  Numbers after;
  std::size_t at = 0;
  for (const SemanticTokenCache::Edit& edit : edits) {
    EXPECT_GE(edit.start, at) << "edits overlap or are out of order";
    after.insert(after.end(), before.begin() + static_cast<std::ptrdiff_t>(at),
                 before.begin() + static_cast<std::ptrdiff_t>(edit.start));
    const Numbers inserted = numbers("[" + edit.data + "]");
    after.insert(after.end(), inserted.begin(), inserted.end());
    at = edit.start + edit.delete_count;
  }
  after.insert(after.end(), before.begin() + static_cast<std::ptrdiff_t>(at), before.end());
  return after;
}

/// The tokens by the protocol's rules, without any of the cache's means.
Numbers plainly_encoded(const Snapshot& snapshot, ColumnUnit unit) {
  Numbers result;
  Position last;
  for (const features::SemanticToken& token : features::semantic_tokens(snapshot, {0, snapshot.text().size()})) {
    const Position begin = snapshot.text().position(token.span.begin, unit);
    const Position end = snapshot.text().position(token.span.end, unit);
    EXPECT_EQ(begin.line, end.line);
    if (begin.line != last.line) last.column = 0;
    result.insert(result.end(), {begin.line - last.line, begin.column - last.column, end.column - begin.column,
                                 static_cast<uint32_t>(token.type), token.modifiers});
    last = begin;
  }
  return result;
}

/// A document with a client's view of its tokens.
class Editor {
 public:
  Editor(std::string text, ColumnUnit unit) : document_(std::move(text)), unit_(unit) {
    cache_.update(document_.snapshot(), unit_, ++results_);
    client_ = numbers(cache_.data());
  }

  uint32_t size() const { return document_.text().size(); }
  std::string text() const { return std::string(document_.text().slice({0, size()})); }

  void replace(Span span, const std::string& with) {
    cache_.text_replaced(span, size());
    document_.replace(span, with);
  }
  void set_text(const std::string& text) {
    cache_.text_set();
    document_.set_text(text);
  }
  /// What a client gets that asks for what changed.
  std::vector<SemanticTokenCache::Edit> ask() {
    const auto change = cache_.update(document_.snapshot(), unit_, ++results_);
    const auto edits = cache_.edits(change);
    client_ = applied(client_, edits);
    return edits;
  }

  const Numbers& client() const { return client_; }
  Numbers full() const { return numbers(cache_.data()); }
  Numbers wanted() { return plainly_encoded(document_.snapshot(), unit_); }

 private:
  Document document_;
  ColumnUnit unit_;
  SemanticTokenCache cache_;
  uint64_t results_ = 0;
  Numbers client_;
};

/// Edits as people and faulty programs make them.
class RandomEdits {
 public:
  explicit RandomEdits(uint64_t seed) : random_(seed) {}

  void edit(Editor& editor) {
    const uint32_t size = editor.size();
    const uint32_t begin = size == 0 ? 0 : static_cast<uint32_t>(random_.below(size));
    switch (random_.below(12)) {
      case 0:
        return editor.replace({begin, std::min(size, begin + static_cast<uint32_t>(random_.below(400)))}, "");
      case 1:
        return editor.replace(
            {begin, begin}, "\n\\begin{equation}\n " + random_.one_of(names_) + " = 1 + \\theta_h\n\\end{equation}\n");
      case 2:
        return editor.set_text(undo_.empty() ? editor.text() : random_.one_of(undo_));
      case 3:
      case 4:
        return editor.replace({begin, std::min(size, begin + 1 + static_cast<uint32_t>(random_.below(3)))}, "");
      case 5:
        undo_.push_back(editor.text());
        if (undo_.size() > 8) undo_.erase(undo_.begin());
        return;
      default:
        return editor.replace({begin, begin}, random_.one_of(pieces_));
    }
  }

  test::Random& random() { return random_; }

 private:
  test::Random random_;
  std::vector<std::string> undo_;
  std::vector<std::string> names_{"\\theta_h", "a", "zz", "g(x, \\vec{v})", "\\omega_i"};
  std::vector<std::string> pieces_{"%",
                                   "1",
                                   "{",
                                   "}",
                                   "$",
                                   "\\begin{equation}",
                                   "\\end{equation}",
                                   "\\begin{verbatim}",
                                   "\\end{verbatim}",
                                   "\n",
                                   "\r",
                                   "=",
                                   "(",
                                   ")",
                                   "\\theta_h",
                                   "\\vec{",
                                   " + x_{a\n b}",
                                   "\\end{document}",
                                   "θ",
                                   "😀",
                                   "\t",
                                   "\n\n",
                                   "x",
                                   "_",
                                   "\\",
                                   "\r\n",
                                   "\\verb|",
                                   "\\begin{equation*}"};
};

class SemanticTokenDelta : public testing::TestWithParam<ColumnUnit> {};

TEST_P(SemanticTokenDelta, GivesWhatFullTokensAre) {
  std::size_t longest = 0;
  std::size_t compared = 0;
  for (uint64_t seed = 1; seed <= 12; ++seed) {
    RandomEdits edits(seed);
    Editor editor("θ😀 " + test::random_document(seed) + " 😀 " + test::random_document(seed + 100), GetParam());
    for (int step = 0; step < 150; ++step) {
      for (std::size_t count = 1 + edits.random().below(3); count > 0; --count) edits.edit(editor);
      editor.ask();
      const Numbers wanted = editor.wanted();
      ASSERT_EQ(editor.full(), wanted) << "seed " << seed << " step " << step << "\n" << editor.text();
      ASSERT_EQ(editor.client(), wanted) << "seed " << seed << " step " << step << "\n" << editor.text();
      longest = std::max(longest, wanted.size());
      compared += wanted.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(longest, 1000u);
  EXPECT_GT(compared, 1000u);
}

INSTANTIATE_TEST_SUITE_P(Units, SemanticTokenDelta,
                         testing::Values(ColumnUnit::Utf8, ColumnUnit::Utf16, ColumnUnit::CodePoint));

std::string equation(const std::string& content) {
  return "\\begin{equation}" + content + "\\end{equation}\n";
}

TEST(SemanticTokenCache, AnEditTouchesItsBlockAndThePlaceBehind) {
  std::string text;
  for (int i = 0; i < 50; ++i) text += equation("a_{" + std::to_string(i) + "} = 1");
  Editor editor(text, ColumnUnit::Utf16);
  const auto place = static_cast<uint32_t>(text.find("a_{20} = 1") + 9);

  editor.replace({place, place + 1}, "2");
  EXPECT_TRUE(editor.ask().empty()) << "the tokens are where they were";

  editor.replace({place, place + 1}, "25");
  const auto longer = editor.ask();
  ASSERT_EQ(longer.size(), 1u);
  EXPECT_EQ(longer[0].start, 20u * 3 * 5);
  EXPECT_EQ(longer[0].delete_count, 15u);
  EXPECT_EQ(longer[0].data, "1,16,6,1,2,0,7,1,4,0,0,2,2,3,0");

  editor.replace({place, place}, "\n");
  const auto moved = editor.ask();
  ASSERT_EQ(moved.size(), 1u) << "the next line's tokens are as far away as before";

  const auto behind = static_cast<uint32_t>(editor.text().find("\n\\begin{equation}a_{30}"));
  editor.replace({behind, behind}, "\n");
  const auto pushed = editor.ask();
  ASSERT_EQ(pushed.size(), 1u);
  EXPECT_EQ(pushed[0].start, 30u * 3 * 5);
  EXPECT_EQ(pushed[0].delete_count, 2u);
  EXPECT_EQ(pushed[0].data, "2,16");
  EXPECT_EQ(editor.client(), editor.wanted());
}

TEST(SemanticTokenCache, HidingAConventionChangesTokensEverywhere) {
  Editor editor(equation("a = \\theta_h") + equation("b = 1") + equation("c = \\theta_h"), ColumnUnit::Utf16);
  editor.replace({0, 0}, equation("\\theta_h = 1"));
  editor.ask();
  EXPECT_EQ(editor.client(), editor.wanted());
}

TEST(SemanticTokenCache, AnEmptyDocumentHasNone) {
  Editor editor("", ColumnUnit::Utf16);
  EXPECT_TRUE(editor.full().empty());
  editor.set_text(equation("a = 1"));
  EXPECT_EQ(editor.ask().size(), 1u);
  EXPECT_EQ(editor.client(), editor.wanted());
  editor.set_text("");
  EXPECT_EQ(editor.ask().size(), 1u);
  EXPECT_TRUE(editor.client().empty());
  EXPECT_TRUE(editor.ask().empty());
}

}  // namespace
}  // namespace texbrdf::lsp
