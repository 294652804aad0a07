#include <gtest/gtest.h>

#include <thread>

#include "semantics/names.h"
#include "syntax/block_scanner.h"

namespace texbrdf {
namespace {

struct ReadName {
  Name name;
  std::string canonical;
};

ReadName read(const std::string& spelling) {
  const std::string text = "\\begin{equation}" + spelling + " = 1\\end{equation}";
  const ParsedBlock block = parse_block(text, scan_blocks(text).at(0));
  const NodeId node = block.definitions.at(0).name;
  const Name name = read_name(block, node);
  return {name, canonical_form(name)};
}

struct Spelling {
  const char* written;
  const char* canonical;
};

class CanonicalForm : public testing::TestWithParam<Spelling> {};

TEST_P(CanonicalForm, IsOneForAllSpellings) {
  EXPECT_EQ(read(GetParam().written).canonical, GetParam().canonical);
}

TEST_P(CanonicalForm, IsAValidSpellingOfItself) {
  EXPECT_EQ(read(GetParam().canonical).canonical, GetParam().canonical);
}

INSTANTIATE_TEST_SUITE_P(Names, CanonicalForm,
                         testing::ValuesIn(std::vector<Spelling>{
                             {"n", "n"},
                             {"uH", "uH"},
                             {"\\rho", "\\rho"},
                             {"x_1", "x_1"},
                             {"x_{1}", "x_1"},
                             {"x _ { 1 }", "x_1"},
                             {"x_{{1}}", "x_1"},
                             {"x_12", "x_{12}"},
                             {"x_{ab}", "x_{ab}"},
                             {"x_ab", "x_{ab}"},
                             {"x_{n+1}", "x_{n+1}"},
                             {"x_{ n + 1 }", "x_{n+1}"},
                             {"f_{n_i}", "f_{n_i}"},
                             {"f_{n_{i}}", "f_{n_i}"},
                             {"f_{a_{b_{cd}}}", "f_{a_{b_{cd}}}"},
                             {"s_\\alpha", "s_\\alpha"},
                             {"s_{\\alpha}", "s_\\alpha"},
                             {"s_{\\alpha b}", "s_{\\alpha b}"},
                             {"s_{{\\alpha}b}", "s_{\\alpha b}"},
                             {"\\phi_{\\text{diff}}", "\\phi_{diff}"},
                             {"\\phi_\\text{diff}", "\\phi_{diff}"},
                             {"\\phi_{\\mathrm{diff}}", "\\phi_{diff}"},
                             {"\\phi_{{\\rm diff}}", "\\phi_{diff}"},
                             {"\\phi_{\\rm diff}", "\\phi_{diff}"},
                             {"\\phi_{\\mathrm{d}}", "\\phi_d"},
                             {"\\phi_\\mathrm d", "\\phi_d"},
                             {"\\phi_{\\alpha\\text{d}}", "\\phi_{\\alpha d}"},
                             {"F_{\\text{D90}}", "F_{D90}"},
                             {"x_{\\text{a b}}", "x_{\\text{a b}}"},
                             {"f_\\text{cook\\_torrance}", "f_{\\text{cook\\_torrance}}"},
                             {"\\text{cook\\_torrance}", "\\text{cook\\_torrance}"},
                             {"\\text{ two  words }", "\\text{two words}"},
                             {"\\mathrm{two words}", "\\text{twowords}"},
                             {"\\mathit{x}", "\\text{x}"},
                             {"\\operatorname{lerp}", "\\text{lerp}"},
                             {"\\operatorname*{lerp}", "\\text{lerp}"},
                             {"\\mathrm x", "\\text{x}"},
                             {"{\\rm two words}", "\\text{twowords}"},
                             {"\\mbox{ two  words }", "\\text{two words}"},
                             {"\\vec{n}", "\\vec{n}"},
                             {"\\vec{ n }", "\\vec{n}"},
                             {"\\vec{C_{s}}", "\\vec{C_s}"},
                             {"\\vec{C}_s", "\\vec{C_s}"},
                             {"\\vec{C_a}_b", "\\vec{C_a}_b"},
                             {"\\vec{\\text{n}}", "\\vec{\\text{n}}"},
                             {"\\mathbf{n}", "\\vec{n}"},
                             {"\\mathbf n", "\\vec{n}"},
                             {"\\boldsymbol{n}", "\\vec{n}"},
                             {"\\bm n", "\\vec{n}"},
                             {"\\pmb n", "\\vec{n}"},
                             {"\\textbf{n}", "\\vec{n}"},
                             {"\\hat n", "\\vec{n}"},
                             {"\\overrightarrow{n}", "\\vec{n}"},
                             {"\\hat{\\mathbf n}", "\\vec{n}"},
                             {"\\hat\\mathbf{n}", "\\vec{n}"},
                             {"\\vec{\\vec{n}}", "\\vec{n}"},
                             {"\\mathbf{{n}}", "\\vec{n}"},
                             {"{\\bf n}", "\\vec{n}"},
                             {"{\\bm n}", "\\vec{n}"},
                             {"{\\bf NH}", "\\vec{NH}"},
                             {"\\bf n", "\\vec{n}"},
                             {"{\\bf k}_1", "\\vec{k_1}"},
                             {"{\\bf k_{12}}", "\\vec{k_{12}}"},
                             {"\\vec k_1", "\\vec{k_1}"},
                             {"\\hat\\omega_m", "\\vec{\\omega_m}"},
                             {"\\hat\\omega_i", "\\omega_i"},
                             {"\\bar{\\mu}", "\\bar{\\mu}"},
                             {"\\bar\\mu_0", "\\bar{\\mu_0}"},
                             {"\\bar{\\mathbf x}", "\\bar{\\vec{x}}"},
                             {"\\mathbf{\\bar x}_1", "\\vec{\\bar{x_1}}"},
                             {"\\mathcal F", "\\mathcal{F}"},
                             {"{\\cal F}_1", "\\cal{F_1}"},
                             {"v'", "v'"},
                             {"x''", "x''"},
                             {"f'_d", "f_d'"},
                             {"f_d'", "f_d'"},
                             {"f_d^\\prime", "f_d'"},
                             {"f_d^{\\prime\\prime}", "f_d''"},
                             {"\\mathbf{l}'", "\\vec{l}'"},
                             {"\\mathbf{l'}", "\\vec{l}'"},
                             {"\\mathbf l'_1", "\\vec{l_1}'"},
                             {"f_{l'}", "f_{l'}"},
                             {"x_{\\vec{n}}", "x_{\\vec{n}}"},
                             {"x_{\\mathbf n}", "x_{\\vec{n}}"},
                             {"x_\\mathbf{n}", "x_{\\vec{n}}"},
                             {"x_{\\hat\\mathbf n}", "x_{\\vec{n}}"},
                             {"x_{\\hat{\\mathbf{n}}}", "x_{\\vec{n}}"},
                             {"x_{\\bf n}", "x_{\\vec{n}}"},
                             {"x_{\\bar\\alpha_1}", "x_{\\bar{\\alpha}_1}"},
                             {"x_\\bar\\alpha", "x_{\\bar{\\alpha}}"},
                             {"x_{\\hat\\bar{ab} c}", "x_{\\vec{\\bar{ab}}c}"},
                             {"\\omega_i", "\\omega_i"},
                             {"\\vec{\\omega_i}", "\\omega_i"},
                             {"\\vec{\\omega}_{i}", "\\omega_i"},
                             {"\\vec{\\omega_o}", "\\omega_o"},
                             {"\\vec{\\theta_i}", "\\vec{\\theta_i}"},
                         }));

TEST(ReadName, GivesItsParts) {
  const Name plain = read("\\rho_d").name;
  EXPECT_EQ(plain.base, "rho");
  EXPECT_TRUE(plain.is_command);
  EXPECT_FALSE(plain.is_text);
  EXPECT_TRUE(plain.decorations.empty());
  EXPECT_EQ(plain.subscripts, std::vector<std::string>{"d"});

  const Name text = read("\\text{cook\\_torrance}").name;
  EXPECT_EQ(text.base, "cook_torrance");
  EXPECT_FALSE(text.is_command);
  EXPECT_TRUE(text.is_text);

  const Name vector = read("\\vec{\\omega_i}").name;
  EXPECT_EQ(vector.base, "omega");
  EXPECT_TRUE(vector.is_command);
  EXPECT_TRUE(vector.is_vector());
  EXPECT_EQ(vector.decorations, std::vector<std::string>{"vec"});
  EXPECT_EQ(vector.subscripts, std::vector<std::string>{"i"});
}

TEST(ReadName, CountsPrimesWhereverTheyStand) {
  const Name primed = read("\\mathbf{l'}_i'").name;
  EXPECT_EQ(primed.base, "l");
  EXPECT_EQ(primed.primes, 2u);
  EXPECT_EQ(primed.subscripts, std::vector<std::string>{"i"});
}

TEST(ReadName, ReadsDeepSubscripts) {
  const int depth = 500;
  std::string spelling = "x";
  for (int i = 0; i < depth; ++i) spelling += "_{a";
  spelling.append(depth, '}');
  EXPECT_EQ(read(spelling).name.base, "x");
}

TEST(NameTable, NumbersNamesInOrder) {
  NameTable table;
  const NameId a = table.intern("a");
  const NameId b = table.intern("\\vec{n}");
  EXPECT_EQ(table.intern("a"), a);
  EXPECT_NE(a, b);
  EXPECT_EQ(table.find("\\vec{n}"), b);
  EXPECT_EQ(table.text(b), "\\vec{n}");
  EXPECT_EQ(table.traits(b).convention, Convention::Normal);
  EXPECT_FALSE(table.find("c").valid());
  EXPECT_EQ(table.size(), 2u);
}

TEST(NameTable, IsReadWhileItGrows) {
  NameTable table;
  const NameId first = table.intern("first");
  std::thread reader([&] {
    for (int i = 0; i < 20'000; ++i) {
      ASSERT_EQ(table.find("first"), first);
      ASSERT_EQ(table.text(first), "first");
    }
  });
  for (int i = 0; i < 20'000; ++i) table.intern("name" + std::to_string(i));
  reader.join();
  for (int i = 0; i < 20'000; ++i) ASSERT_TRUE(table.find("name" + std::to_string(i)).valid());
}

struct Trait {
  const char* canonical;
  bool is_vector, is_reserved, is_foreign_command, is_convention;
};

TEST(NameTraits, FollowFromTheSpelling) {
  const Trait traits[] = {{"x", false, false, false, false},           {"\\vec{x}", true, false, false, false},
                          {"\\omega_i", true, false, false, true},     {"\\omega_x", false, false, false, false},
                          {"exp", false, true, false, false},          {"max_1", false, true, false, false},
                          {"expo", false, false, false, false},        {"x_{exp}", false, false, false, false},
                          {"\\text{exp}", false, false, false, false}, {"\\vec{max}", true, true, false, false},
                          {"\\foo", false, false, true, false},        {"\\vec{\\foo}", true, false, true, false},
                          {"\\alpha", false, false, false, false},     {"\\varphi_1", false, false, false, false},
                          {"\\pi", false, false, false, true},         {"\\theta_d", false, false, false, true},
                          {"\\mathrm{x}", false, false, false, false}};
  for (const Trait& expected : traits) {
    const NameTraits found = name_traits(expected.canonical);
    EXPECT_EQ(found.is_vector, expected.is_vector) << expected.canonical;
    EXPECT_EQ(found.is_reserved, expected.is_reserved) << expected.canonical;
    EXPECT_EQ(found.is_foreign_command, expected.is_foreign_command) << expected.canonical;
    EXPECT_EQ(found.convention.has_value(), expected.is_convention) << expected.canonical;
  }
}

}  // namespace
}  // namespace texbrdf
