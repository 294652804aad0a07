#include "features/model_parameters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "analysis/document.h"

namespace texbrdf::features {
namespace {

std::string document_of(const std::string& literal, const std::string& comment = "") {
  return "\\begin{equation}\nm = " + literal + comment +
         "\n\\end{equation}\n\\begin{equation}\nf = \\vec{1,1,1} * m\n" + "\\end{equation}\n";
}

/// The literal after the parameter has got the value, or why it has not.
std::string written(const std::string& literal, const std::vector<double>& value, const std::string& comment = "") {
  Document document(document_of(literal, comment));
  const auto edits = parameter_edit(document.snapshot(), "m", value);
  if (!edits) return "nothing";
  for (auto edit = edits->rbegin(); edit != edits->rend(); ++edit) document.replace(edit->span, edit->text);
  const std::string text = document.text().bytes();
  const size_t begin = text.find("m = ") + 4;
  return text.substr(begin, std::min(text.find(" %", begin), text.find('\n', begin)) - begin);
}

TEST(ModelParameters, AreThoseThatTheRootNeeds) {
  Document document(
      "\\begin{equation}\n\\rho_d = \\vec{0.5, 0.25, 0} % range [0, 1]\n\\end{equation}\n"
      "\\begin{equation}\nm = 0.3 % range [0.01, 2]\n\\end{equation}\n"
      "\\begin{equation}\nunused = 4\n\\end{equation}\n"
      "\\begin{equation}\nf = \\rho_d / m\n\\end{equation}\n");
  const std::vector<ModelParameter> parameters = model_parameters(document.snapshot());
  ASSERT_EQ(parameters.size(), 2u);
  EXPECT_EQ(parameters[0].name, "\\rho_d");
  EXPECT_EQ(parameters[0].type, Type::Colour);
  EXPECT_EQ(parameters[0].value, (std::array<double, 3>{0.5, 0.25, 0}));
  EXPECT_EQ(document.text().slice(parameters[0].literal), "\\vec{0.5, 0.25, 0}");
  EXPECT_EQ(parameters[1].name, "m");
  EXPECT_EQ(parameters[1].low, 0.01);
  EXPECT_EQ(parameters[1].high, 2);
  EXPECT_EQ(document.text().slice(parameters[1].literal), "0.3");
}

TEST(ModelParameters, AreNoneWhereTheRootIsInError) {
  Document document("\\begin{equation}\nf = 0.3 + zq\n\\end{equation}\n");
  EXPECT_TRUE(model_parameters(document.snapshot()).empty());
}

TEST(ParameterEdit, KeepsTheNotationOfTheDocument) {
  EXPECT_EQ(written(".3", {0.25}, " % range [0, 1]"), ".25");
  EXPECT_EQ(written("-0.5", {0.25}, " % range [-1, 1]"), "0.25");
  EXPECT_EQ(written("2e-3", {0.005}, " % range [0, 1]"), "5e-3");
  EXPECT_EQ(written("2e-3", {20}, " % range [0, 1]"), "2e1");
  EXPECT_EQ(written("(0.5, .25, 0)", {0.5, 0.75, 1}), "(0.5, .75, 1)");
}

TEST(ParameterEdit, RoundsToWhatASliderCanMean) {
  EXPECT_EQ(written("0.3", {0.4567891}, " % range [0, 1]"), "0.457");
  EXPECT_EQ(written("20", {63.271234}, " % range [1, 1000]"), "63.3");
  EXPECT_EQ(written("2e-3", {0.005123456}, " % range [0, 1]"), "5.12e-3");
  EXPECT_EQ(written("-0.5", {-0.000123456789}, " % range [-1, 1]"), "0");
  EXPECT_EQ(written("0.5", {0.1 + 0.2}, " % range [0, 1]"), "0.3");
}

TEST(ParameterEdit, LeavesANumberAsItWasMeant) {
  EXPECT_EQ(written("0.3", {0.12345}, " % range [0, 1]"), "0.12345");
  EXPECT_EQ(written("20", {63.27}, " % range [1, 1000]"), "63.27");
  EXPECT_EQ(written("0.5", {123456}, " % range [0, 1]"), "123456");
  EXPECT_EQ(written("0.5", {1e-20}, " % range [0, 1]"), "1e-20");
  EXPECT_EQ(written("0.5", {1.5e300}, " % range [0, 1]"), "1.5e300");
  EXPECT_EQ(written("0.5", {-0.0}, " % range [0, 1]"), "0");
}

TEST(ParameterEdit, KeepsNoDigitsOfTheNumberThatItReplaces) {
  EXPECT_EQ(written("0.300", {0.5}, " % range [0, 1]"), "0.5");
  EXPECT_EQ(written("20.00", {64}, " % range [1, 1000]"), "64");
  EXPECT_EQ(written("2.000e-3", {0.001}, " % range [0, 1]"), "1e-3");
  EXPECT_EQ(written("\\vec{0.699, 0.319, 0.604}", {0.7, 0.35, 0.2}), "\\vec{0.7, 0.35, 0.2}");
}

TEST(ParameterEdit, WritesOnlyTheComponentsThatChange) {
  EXPECT_EQ(written("\\vec{0.5, .25, 1.0}", {0.5, 0.125, 1}), "\\vec{0.5, .125, 1.0}");
  EXPECT_EQ(written("\\vec{0.5,  0.25,1}", {0.1, 0.2, 0.3}), "\\vec{0.1,  0.2,0.3}");
}

TEST(ParameterEdit, RefusesWhatIsNoValueOfIt) {
  EXPECT_EQ(written("0.3", {1, 2, 3}), "nothing");
  EXPECT_EQ(written("0.3", {std::numeric_limits<double>::infinity()}), "nothing");
  EXPECT_EQ(written("\\sqrt{2}", {1}), "nothing");
  Document document(document_of("0.3"));
  EXPECT_FALSE(parameter_edit(document.snapshot(), "zq", std::vector<double>{1}));
}

TEST(BrdfNames, AreThoseThatMayBeDrawn) {
  Document document(
      "\\begin{equation}\nf_d = 1\n\\end{equation}\n\\begin{equation}\ng = 2\n\\end{equation}\n"
      "\\begin{equation}\nf_s = \\theta_h\n\\end{equation}\n");
  EXPECT_EQ(brdf_names(document.snapshot()), (std::vector<std::string>{"f_d", "f_s"}));
}

}  // namespace
}  // namespace texbrdf::features
