// Documents in the notation of papers against values that do not come from texbrdf.

#include "model.h"
#include "support/paper_documents.h"

namespace texbrdf::test {
namespace {

using eval::Geometry;
using eval::Triple;

constexpr double kRelativeDouble = 1e-4;
constexpr double kRelativeSingle = 1e-3;
constexpr double kAbsolute = 1e-6;

class Paper : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const std::string path = std::string(TEXBRDF_TEST_DATA) + "/" + GetParam();
    Result<eval::CompiledModel> model = compile_text(read_text(path + ".tex"));
    ASSERT_TRUE(model) << model.error();
    model_ = *std::move(model);
    rows_ = read_rows(path + ".csv");
    ASSERT_FALSE(rows_.empty());
  }

  void expect_published(const std::vector<Triple>& values, double relative, const std::string& what) const {
    Deviation deviation(relative, kAbsolute);
    ASSERT_EQ(values.size(), rows_.size());
    for (size_t i = 0; i < values.size(); ++i) {
      deviation.compare(values[i], rows_[i].value, what + ", row " + std::to_string(i + 1));
    }
    EXPECT_LE(deviation.share(), 1) << deviation.first_failure();
  }

  std::vector<Triple> in_double(const ir::Graph& graph) const {
    const eval::ReferenceEvaluator evaluator(graph);
    std::vector<Triple> values;
    for (const ReferenceRow& row : rows_) values.push_back(evaluator.evaluate(row.geometry, model_.parameters));
    return values;
  }

  eval::CompiledModel model_;
  std::vector<ReferenceRow> rows_;
};

TEST_P(Paper, HasItsValuesInDouble) {
  expect_published(in_double(model_.unoptimised), kRelativeDouble, "no passes");
  expect_published(in_double(model_.optimised), kRelativeDouble, "all passes");
}

TEST_P(Paper, HasItsValuesInSingle) {
  std::vector<Geometry> geometries;
  for (const ReferenceRow& row : rows_) geometries.push_back(row.geometry);
  for (const eval::Backend& backend : eval::backends()) {
    const eval::BatchEvaluator evaluator(model_.optimised, backend.set, *backend.functions);
    expect_published(evaluate_batch(evaluator, geometries, model_.parameters), kRelativeSingle, backend.name);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Paper, testing::ValuesIn(paper_documents()),
                         [](const auto& test) { return paper_test_name(test.param); });

}  // namespace
}  // namespace texbrdf::test
