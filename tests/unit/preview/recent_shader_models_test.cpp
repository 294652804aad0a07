#include "preview/recent_shader_models.h"

#include <gtest/gtest.h>

#include <string>

#include "analysis/document.h"

namespace texbrdf::preview {
namespace {

std::shared_ptr<const ir::Program> program(const std::string& value) {
  Document document("\\begin{equation}\nf = " + value + " * \\cos{\\theta_i}\n\\end{equation}\n");
  return std::make_shared<const ir::Program>(*document.snapshot().program("f"));
}

TEST(RecentShaderModels, ProgramsThatTakeTurnsAreEmittedOnce) {
  RecentShaderModels models;
  const auto one = program("0.125");
  const auto other = program("0.375");
  const render::ShaderModel* const of_one = *models.of(one);
  const render::ShaderModel* const of_other = *models.of(other);
  EXPECT_NE(of_one->source, of_other->source);
  EXPECT_EQ(*models.of(one), of_one);
  EXPECT_EQ(*models.of(other), of_other);
  EXPECT_EQ(*models.of(one), of_one);
}

TEST(RecentShaderModels, OnlyThoseThatWereUsedLastAreKept) {
  RecentShaderModels models;
  const auto used = program("0.5");
  const auto unused = program("0.5");
  const render::ShaderModel* const model = *models.of(used);
  ASSERT_TRUE(models.of(unused));
  for (std::size_t i = 0; i < RecentShaderModels::kMost; ++i) {
    ASSERT_TRUE(models.of(program("0.25")));
    EXPECT_EQ(*models.of(used), model);
  }
  EXPECT_EQ(unused.use_count(), 1) << "it is kept nowhere else";
  EXPECT_EQ(used.use_count(), 2);
}

}  // namespace
}  // namespace texbrdf::preview
