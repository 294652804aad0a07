#pragma once

#include <cmath>

#include "model.h"

namespace texbrdf::test {

/// A document whose f has a value that is known without it.
struct ClosedForm {
  const char* name;
  const char* document;
  double expected;
  double tolerance = 1e-9;  ///< relative
};

inline eval::Geometry some_geometry() {
  return {.light = {0.6, 0, 0.8}, .view = {0, -0.28, 0.96}};
}

/// With and without passes, in double and in single precision.
inline void expect_closed_form(const ClosedForm& example) {
  const Result<eval::CompiledModel> model = compile_text(example.document);
  ASSERT_TRUE(model) << model.error();
  const double scale = std::max(1.0, std::abs(example.expected));
  for (const ir::Graph* graph : {&model->unoptimised, &model->optimised}) {
    const double value = eval::ReferenceEvaluator(*graph).evaluate(some_geometry(), model->parameters)[0];
    EXPECT_NEAR(value, example.expected, example.tolerance * scale);
  }
  for (const eval::Backend& backend : eval::backends()) {
    const eval::BatchEvaluator evaluator(model->optimised, backend.set, *backend.functions);
    const std::vector<eval::Triple> values = evaluate_batch(evaluator, {some_geometry()}, model->parameters);
    EXPECT_NEAR(values[0][0], example.expected, std::max(example.tolerance, 2e-5) * scale) << backend.name;
  }
}

inline std::string closed_form_name(const testing::TestParamInfo<ClosedForm>& test) {
  return test.param.name;
}

}  // namespace texbrdf::test
