// Every model against its published values, by every way that there is to evaluate it.

#include <cstdio>

#include "model.h"

namespace texbrdf::test {
namespace {

using eval::Geometry;
using eval::Triple;

constexpr double kRelativeDouble = 1e-6;
constexpr double kRelativeSingle = 1e-3;
constexpr double kAbsoluteSingle = 1e-6;  // some values are below the smallest float

class Model : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    Result<eval::CompiledModel> model = compile_text(read_text(model_path(GetParam(), ".tex")));
    ASSERT_TRUE(model) << model.error();
    model_ = *std::move(model);
    rows_ = read_reference(GetParam());
    ASSERT_EQ(rows_.size(), 200u);
  }

  std::vector<Geometry> geometries() const {
    std::vector<Geometry> result;
    for (const ReferenceRow& row : rows_) result.push_back(row.geometry);
    return result;
  }

  std::vector<Triple> published() const {
    std::vector<Triple> result;
    for (const ReferenceRow& row : rows_) result.push_back(row.value);
    return result;
  }

  std::vector<Triple> in_double(const ir::Graph& graph, const std::vector<Geometry>& geometries) const {
    const eval::ReferenceEvaluator evaluator(graph);
    std::vector<Triple> result;
    for (const Geometry& geometry : geometries) result.push_back(evaluator.evaluate(geometry, model_.parameters));
    return result;
  }

  /// Compares, prints the largest deviation.
  void expect_equal(const std::vector<Triple>& actual, const std::vector<Triple>& expected, double relative,
                    double absolute, const std::string& what) const {
    Deviation deviation(relative, absolute);
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i) {
      deviation.compare(actual[i], expected[i], what + ", row " + std::to_string(i + 1));
    }
    EXPECT_LE(deviation.share(), 1) << deviation.first_failure();
    std::printf("%-32s %-36s largest relative deviation %.2e, %.0e of what is allowed\n", GetParam().c_str(),
                what.c_str(), deviation.largest_relative(), deviation.share());
  }

  void expect_batches(const std::vector<Geometry>& geometries, const std::vector<Triple>& expected) const {
    for (const eval::Backend& backend : eval::backends()) {
      const eval::BatchEvaluator evaluator(model_.optimised, backend.set, *backend.functions);
      expect_equal(evaluate_batch(evaluator, geometries, model_.parameters), expected, kRelativeSingle, kAbsoluteSingle,
                   backend.name);
    }
  }

  eval::CompiledModel model_;
  std::vector<ReferenceRow> rows_;
};

TEST_P(Model, HasItsPublishedValuesInDouble) {
  expect_equal(in_double(model_.unoptimised, geometries()), published(), kRelativeDouble, 0, "double, no passes");
  expect_equal(in_double(model_.optimised, geometries()), published(), kRelativeDouble, 0, "double, all passes");
}

TEST_P(Model, HasItsPublishedValuesInSingle) {
  expect_batches(geometries(), published());
}

/// A model that builds its own tangent from a fixed axis changes its values with the frame: what it is held against
/// here is the unoptimised graph.
TEST_P(Model, IsTheSameInRotatedFramesByAllWays) {
  Random random(7);
  std::vector<Geometry> rotated;
  for (const Geometry& geometry : geometries()) rotated.push_back(in_single_precision(Rotation(random)(geometry)));
  const std::vector<Triple> expected = in_double(model_.unoptimised, rotated);
  expect_equal(in_double(model_.optimised, rotated), expected, kRelativeDouble, 0, "rotated, double, all passes");
  expect_batches(rotated, expected);
}

std::string test_name(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(All, Model, testing::ValuesIn(model_names()), test_name);

}  // namespace
}  // namespace texbrdf::test
