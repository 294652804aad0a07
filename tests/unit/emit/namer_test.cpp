#include "emit/namer.h"

#include <gtest/gtest.h>

namespace texbrdf::emit {
namespace {

Name name(std::string base, std::vector<std::string> subscripts = {}) {
  Name result;
  result.base = std::move(base);
  result.subscripts = std::move(subscripts);
  return result;
}

Name text(std::string base) {
  Name result = name(std::move(base));
  result.is_text = true;
  return result;
}

Name decorated(std::string decoration, std::string base) {
  Name result = name(std::move(base));
  result.decorations = {std::move(decoration)};
  return result;
}

TEST(Identifier, ReadsLikeTheName) {
  EXPECT_EQ(identifier(name("rho", {"d"})), "rho_d");
  EXPECT_EQ(identifier(text("cook_torrance")), "cook_torrance");
  EXPECT_EQ(identifier(text("cook\\_torrance")), "cook_torrance");
  EXPECT_EQ(identifier(decorated("vec", "H")), "H");
  EXPECT_EQ(identifier(decorated("bar", "mu")), "mu_bar");
  EXPECT_EQ(identifier(name("f", {"{n_i}"})), "f_n_i");
  EXPECT_EQ(identifier(name("x", {"n+1"})), "x_n_plus_1");
  EXPECT_EQ(identifier(name("phi", {"\\text{diff}"})), "phi_diff");
  EXPECT_EQ(identifier(name("s", {"\\alpha"})), "s_alpha");
  EXPECT_EQ(identifier(name("x", {"\\alpha\\beta"})), "x_alpha_beta");
}

TEST(Identifier, SpeaksPrimes) {
  Name primed = name("x");
  primed.primes = 2;
  EXPECT_EQ(identifier(primed), "x_prime_prime");
}

TEST(Identifier, IsAlwaysLegal) {
  EXPECT_EQ(identifier(name("2nd")), "v2nd");
  EXPECT_EQ(identifier(name("")), "v");
  EXPECT_EQ(identifier(name("__")), "v");
  EXPECT_EQ(identifier(name("a__b")), "a_b");
  EXPECT_EQ(identifier(name("gl_x")), "v_gl_x");
  EXPECT_EQ(identifier(name("\xC3\xA9t\xC3\xA9")), "ue9_t_ue9");
  EXPECT_EQ(identifier(name("\xFF")), "uff");
  EXPECT_EQ(identifier(name(std::string(100, 'a'))), std::string(kLongestIdentifier, 'a'));
}

TEST(Namer, GivesEachNameOnce) {
  Namer names(kGlslDialect);
  EXPECT_EQ(names.claim(name("H")), "H");
  EXPECT_EQ(names.claim(decorated("vec", "H")), "H_vec");
  EXPECT_EQ(names.claim(text("H")), "H_text");
  EXPECT_EQ(names.claim(decorated("vec", "H")), "H_2");
  EXPECT_EQ(names.claim("H"), "H_3");
}

TEST(Namer, AvoidsWordsOfTheLanguage) {
  Namer names(kGlslDialect);
  EXPECT_EQ(names.claim("normalize"), "normalize_");
  EXPECT_EQ(names.claim("normalize"), "normalize_2");
  EXPECT_EQ(names.claim("precise"), "precise_");
  EXPECT_EQ(names.claim("input"), "input_");
  EXPECT_EQ(names.claim("brdf"), "brdf_");
  EXPECT_EQ(names.claim("power"), "power_") << "the name of an emitted helper";
  EXPECT_EQ(names.claim("gamma"), "gamma") << "only the other target forbids it";
}

TEST(Namer, AvoidsWordsOfDisneyBrdfExplorer) {
  Namer names(kExplorerDialect);
  for (std::string word : {"gamma", "incidentVector", "PI_", "Sqr", "thickness", "BRDF"}) {
    const std::string given = names.claim(word);
    EXPECT_NE(given, word);
    EXPECT_FALSE(is_forbidden(kExplorerDialect, given)) << given;
  }
  for (std::string word : {"envLight", "eyeSpaceX", "esTheta", "ts", "lightPDF", "lightSample"}) {
    const std::string given = names.claim(word);
    EXPECT_FALSE(is_forbidden(kExplorerDialect, given)) << given;
  }
}

TEST(Dialect, MatchesWholeWords) {
  EXPECT_TRUE(is_forbidden(kGlslDialect, "uint64_t"));
  EXPECT_FALSE(is_forbidden(kGlslDialect, "uint64"));
  EXPECT_FALSE(is_forbidden(kGlslDialect, "vec"));
  EXPECT_TRUE(is_forbidden(kGlslDialect, "a__b"));
  EXPECT_TRUE(is_forbidden(kGlslDialect, "gl_a"));
}

}  // namespace
}  // namespace texbrdf::emit
