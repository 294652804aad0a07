#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/parse_equation.h"
#include "syntax/print_source.h"

namespace texbrdf {
namespace {

std::string read_file(const std::string& path) {
  std::ifstream file(std::string(TEXBRDF_TEST_DATA) + "/" + path, std::ios::binary);
  EXPECT_TRUE(file) << path;
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Problems of all blocks, in order.
std::string problems(const std::string& document) {
  std::string text;
  for (const BlockExtent& extent : scan_blocks(document)) {
    const ParsedBlock block =
        parse_block(std::string_view(document).substr(extent.whole.begin, extent.whole.size()), extent);
    text += test::diagnostics_text(block);
  }
  return text;
}

struct Document {
  const char* name;
  const char* problems;
};

TEST(ErrorDocuments, have_their_syntax_errors_and_no_others) {
  constexpr Document kDocuments[] = {
      {"undefined", ""},
      {"exp-of-vector", ""},
      {"unbalanced", "E2003 [(]"},
      {"reserved-word", ""},
      {"no-expression", "E2001 [\\end]"},
      {"redefinition", ""},
      {"cycle", ""},
      {"argument-type", ""},
      {"argument-count", ""},
      {"not-a-function", ""},
      {"missing-f", ""},
      {"vector-power", ""},
      {"vector-plus-real", ""},
      {"vector-over-vector", ""},
      {"vector-length", "E2009 [\\vec{1,2}]"},
      {"missing-end", "E2005 [\\begin{equation}]"},
      {"two-errors", ""},
      {"no-cascade", ""},
      {"builtin-redefined", ""},
      {"left-side", "E2007 [1 + 2]"},
      {"missing-operator", ""},
      {"poisoned-parameter", ""},
      {"stray-closer", "E2004 [)]"},
      {"unbalanced-brace", "E2003 [{]"},
      {"unknown-command", ""},
      {"pi-redefined", ""},
  };
  for (const Document& document : kDocuments) {
    EXPECT_EQ(problems(read_file(std::string("errors/") + document.name + ".tex")), document.problems) << document.name;
  }
}

TEST(ModelDocuments, are_read_and_print_what_reads_the_same) {
  for (const char* name :
       {"ashikhmin-shirley", "ashikhmin-shirley-alternative", "blinn-phong", "conventions", "cook-torrance",
        "cook-torrance-alternative", "duer", "edwards-2006", "kajiya-kay", "minnaert", "oren-nayar", "ward"}) {
    const std::string document = read_file(std::string("models/") + name + ".tex");
    for (const BlockExtent& extent : scan_blocks(document)) {
      const ParsedBlock block =
          parse_block(std::string_view(document).substr(extent.whole.begin, extent.whole.size()), extent);
      if (is_inline(extent.region)) continue;
      ASSERT_EQ(block.definitions.size(), 1u) << name;
      ASSERT_TRUE(block.definitions[0].readable) << name << test::diagnostics_text(block);
      const std::string print = print_source(block, block.definitions[0]);
      const ParsedBlock again = test::parse_equation(print);
      EXPECT_EQ(test::diagnostics_text(again), "") << print;
      ASSERT_EQ(again.definitions.size(), 1u) << print;
      EXPECT_EQ(print_source(again, again.definitions[0]), print);
    }
  }
}

TEST(BadPapers, are_underlined_where_their_mistake_is) {
  EXPECT_EQ(problems(read_file("papers/bad/stray_ampersand.tex")).substr(0, 9), "E1003 [&]");
  EXPECT_EQ(problems(read_file("papers/bad/missing_end_equation.tex")), "E2005 [\\begin{equation}]");
}

}  // namespace
}  // namespace texbrdf
