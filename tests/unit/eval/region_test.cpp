// Select, Sum and Product: what is left out, what is repeated, and what cannot leak.

#include <functional>

#include "support/evaluation.h"

namespace texbrdf::eval {
namespace {

using ir::Graph;
using ir::Op;
using ir::ValueId;

/// Both evaluators, on every backend, give `expected` for parameters.
void expect_value(const Graph& graph, const std::vector<Triple>& parameters, const Triple& expected,
                  const std::string& name) {
  const Triple reference = ReferenceEvaluator(graph).evaluate({}, parameters);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_PRED4(is_close, reference[i], expected[i], 1e-14, 0) << name;
  for (const Backend& backend : backends()) {
    const BatchEvaluator evaluator(graph, backend.set, *backend.functions);
    const Triple actual = evaluate_batch(evaluator, {Geometry{}}, parameters)[0];
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_PRED4(is_close, actual[i], expected[i], 1e-6, 0) << name << " on " << backend.name;
    }
  }
}

Triple spread(double x) {
  return {x, x, x};
}

ValueId real_parameter(Graph& graph, uint32_t index) {
  return graph.leaf(Op::Parameter, Type::Real, index);
}

/// reduction of body(variable) from first to last.
ValueId reduce(Graph& graph, Op op, ValueId first, ValueId last, const std::function<ValueId(ValueId)>& body) {
  const uint32_t binder = graph.new_binder();
  const ValueId variable = graph.leaf(Op::BoundVariable, Type::Real, binder);
  return graph.add(op, {first, last, body(variable)}, binder);
}

TEST(Select, TheOtherBranchDoesNotLeak) {
  // x <= 0 ? 2 : 1/sqrt(x), by lanes.
  Graph graph;
  const ValueId x = graph.add(Op::Component, {graph.convention(Convention::OmegaI)}, 0);
  const ValueId condition = graph.add(Op::LessEqual, {x, graph.constant(0)});
  const ValueId otherwise = graph.add(Op::Divide, {graph.constant(1), graph.add(Op::Sqrt, {x})});
  graph.roots = {graph.add(Op::Select, {condition, graph.constant(2), otherwise})};
  std::vector<Geometry> geometries;
  for (int i = 0; i < 300; ++i) geometries.push_back({.light = {i % 3 == 0 ? -1.0 : i, 0, 0}, .view = {}});
  const ReferenceEvaluator reference(graph);
  for (const Backend& backend : backends()) {
    const std::vector<Triple> actual = evaluate_batch(BatchEvaluator(graph, backend.set), geometries);
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      const double expected = i % 3 == 0 ? 2 : 1 / std::sqrt(static_cast<double>(i));
      EXPECT_PRED4(is_close, reference.evaluate(geometries[i], {})[0], expected, 1e-15, 0);
      EXPECT_PRED4(is_close, actual[i][0], expected, 1e-6, 0) << backend.name;
    }
  }
}

TEST(Select, AnswersANanConditionWithTheSecondBranch) {
  Graph graph;
  const ValueId condition = graph.add(Op::Less, {real_parameter(graph, 0), graph.constant(1)});
  graph.roots = {graph.add(Op::Select, {condition, graph.constant(2), graph.constant(3)})};
  expect_value(graph, {spread(0)}, spread(2), "0 < 1");
  expect_value(graph, {spread(1)}, spread(3), "1 < 1");
  expect_value(graph, {spread(kNotANumber)}, spread(3), "NaN < 1");
}

TEST(Select, NestsAndChoosesTruthsAndVectors) {
  // (a < b ? c < d : a = b) ? (1, 2, 3) : (4, 5, 6)
  Graph graph;
  const ValueId a = real_parameter(graph, 0), b = real_parameter(graph, 1);
  const ValueId c = real_parameter(graph, 2), d = real_parameter(graph, 3);
  const auto vector = [&](double x, double y, double z) {
    return graph.add(Op::MakeVector, {graph.constant(x), graph.constant(y), graph.constant(z)});
  };
  const ValueId inner =
      graph.add(Op::Select, {graph.add(Op::Less, {a, b}), graph.add(Op::Less, {c, d}), graph.add(Op::Equal, {a, b})});
  graph.roots = {graph.add(Op::Select, {inner, vector(1, 2, 3), vector(4, 5, 6)})};
  expect_value(graph, {spread(1), spread(2), spread(1), spread(2)}, {1, 2, 3}, "both less");
  expect_value(graph, {spread(1), spread(2), spread(2), spread(1)}, {4, 5, 6}, "only a < b");
  expect_value(graph, {spread(2), spread(2), spread(2), spread(1)}, {1, 2, 3}, "a = b");
  expect_value(graph, {spread(3), spread(2), spread(1), spread(2)}, {4, 5, 6}, "a > b");
}

struct RangeCase {
  std::string name;
  double first, last;
  double sum_of_one;      ///< sum of 1
  double sum_of_squares;  ///< sum of i^2
  double product_of_i;
};

TEST(Reduction, OfEveryKindOfRange) {
  constexpr double kNan = kNotANumber;
  const std::vector<RangeCase> cases = {
      {"three", 1, 3, 3, 14, 6},
      {"one", 4, 4, 1, 16, 4},
      {"negative", -2, 2, 5, 10, 0},
      {"empty", 3, 2, 0, 0, 1},
      {"very empty", 1000, -1e6, 0, 0, 1},
      {"half first", 0.5, 3, kNan, kNan, kNan},
      {"half last", 1, 2.5, kNan, kNan, kNan},
      {"half and empty", 1, 0.5, kNan, kNan, kNan},
      {"nan first", kNan, 3, kNan, kNan, kNan},
      {"nan last", 1, kNan, kNan, kNan, kNan},
      {"infinite", 1, kInfinity, kNan, kNan, kNan},
      {"infinite and empty", 1, -kInfinity, kNan, kNan, kNan},
      {"large bounds", 16777214, 16777216, 3, 844424829468677.0, 4722365638444748636160.0},
      {"bounds too large", 16777218, 16777220, kNan, kNan, kNan},
      {"one iteration too many", 1, 65536, kNan, kNan, kNan},
      {"a million million", 0, 1e12, kNan, kNan, kNan},
  };
  const auto graph_of = [](Op op, const std::function<ValueId(Graph&, ValueId)>& body) {
    Graph graph;
    const ValueId first = real_parameter(graph, 0), last = real_parameter(graph, 1);
    graph.roots = {reduce(graph, op, first, last, [&](ValueId i) { return body(graph, i); })};
    return graph;
  };
  const Graph ones = graph_of(Op::Sum, [](Graph& graph, ValueId) { return graph.constant(1); });
  const Graph squares = graph_of(Op::Sum, [](Graph& graph, ValueId i) { return graph.add(Op::Multiply, {i, i}); });
  const Graph product = graph_of(Op::Product, [](Graph&, ValueId i) { return i; });
  for (const RangeCase& c : cases) {
    const std::vector<Triple> range = {spread(c.first), spread(c.last)};
    expect_value(ones, range, spread(c.sum_of_one), "sum of 1, " + c.name);
    expect_value(squares, range, spread(c.sum_of_squares), "sum of squares, " + c.name);
    expect_value(product, range, spread(c.product_of_i), "product, " + c.name);
  }
  expect_value(ones, {spread(1), spread(65535)}, spread(65535), "as many iterations as there may be");
}

TEST(Reduction, EachLaneHasItsOwnRange) {
  // sum over i from Lx to Ly of i·Lz
  Graph graph;
  const ValueId light = graph.convention(Convention::OmegaI);
  const ValueId first = graph.add(Op::Component, {light}, 0);
  const ValueId last = graph.add(Op::Component, {light}, 1);
  const ValueId factor = graph.add(Op::Component, {light}, 2);
  graph.roots = {reduce(graph, Op::Sum, first, last, [&](ValueId i) { return graph.add(Op::Multiply, {i, factor}); })};
  std::vector<Geometry> geometries;
  for (int i = 0; i < 200; ++i) {
    geometries.push_back({.light = {i % 7 - 3.0, i % 11 == 0 ? 0.5 : i % 13 - 2.0, i * 0.5}, .view = {}});
  }
  const ReferenceEvaluator reference(graph);
  for (const Backend& backend : backends()) {
    const std::vector<Triple> actual = evaluate_batch(BatchEvaluator(graph, backend.set), geometries);
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      double expected = std::trunc(geometries[i].light[1]) == geometries[i].light[1] ? 0 : kNotANumber;
      for (double k = geometries[i].light[0]; k <= geometries[i].light[1]; ++k) expected += k * geometries[i].light[2];
      EXPECT_PRED4(is_close, reference.evaluate(geometries[i], {})[0], expected, 1e-14, 1e-14);
      EXPECT_PRED4(is_close, actual[i][0], expected, 1e-6, 1e-6) << backend.name << " lane " << i;
    }
  }
}

TEST(Reduction, NestsWithBoundsThatDependOnTheOuterVariable) {
  // sum i=1..4 of product j=i..4 of (i + j·p)
  Graph graph;
  const ValueId p = real_parameter(graph, 0), four = graph.constant(4);
  graph.roots = {reduce(graph, Op::Sum, graph.constant(1), four, [&](ValueId i) {
    return reduce(graph, Op::Product, i, four,
                  [&](ValueId j) { return graph.add(Op::Add, {i, graph.add(Op::Multiply, {j, p})}); });
  })};
  double expected = 0;
  for (int i = 1; i <= 4; ++i) {
    double product = 1;
    for (int j = i; j <= 4; ++j) product *= i + j * 0.5;
    expected += product;
  }
  expect_value(graph, {spread(0.5)}, spread(expected), "nested");
}

TEST(Select, InAComponentThatNothingNeeds) {
  Graph graph;
  const ValueId p = real_parameter(graph, 0);
  const ValueId one = graph.constant(1);
  const ValueId selected =
      graph.add(Op::Select, {graph.add(Op::Less, {p, one}), graph.add(Op::Sqrt, {p}), graph.add(Op::Exp, {p})});
  const ValueId sum = reduce(graph, Op::Sum, p, graph.constant(3), [&](ValueId i) { return i; });
  const ValueId vector = graph.add(Op::MakeVector, {selected, sum, p});
  graph.roots = {graph.add(Op::Component, {graph.add(Op::Multiply, {vector, p})}, 2)};
  expect_value(graph, {spread(3)}, spread(9), "third component");
}

TEST(Reduction, OfVectors) {
  Graph graph;
  const ValueId colour = graph.leaf(Op::Parameter, Type::Colour, 0);
  graph.roots = {reduce(graph, Op::Sum, graph.constant(1), graph.constant(3),
                        [&](ValueId i) { return graph.add(Op::Multiply, {i, colour}); })};
  expect_value(graph, {{1, 2, 3}}, {6, 12, 18}, "sum of vectors");
}

TEST(Reduction, UsesItsVariableInSelects) {
  // sum i=-2..2 of (i < 0 ? sqrt(-i) : i)
  Graph graph;
  graph.roots = {reduce(graph, Op::Sum, graph.constant(-2), graph.constant(2), [&](ValueId i) {
    const ValueId root = graph.add(Op::Sqrt, {graph.add(Op::Negate, {i})});
    return graph.add(Op::Select, {graph.add(Op::Less, {i, graph.constant(0)}), root, i});
  })};
  expect_value(graph, {}, spread(std::sqrt(2.0) + 1 + 3), "select by the variable");
}

TEST(Reduction, IsUsedTwiceAndAfterwards) {
  // s = sum i=1..3 of i; s·s + sum j=1..2 of s·j
  Graph graph;
  const ValueId one = graph.constant(1);
  const ValueId s = reduce(graph, Op::Sum, one, graph.constant(3), [](ValueId i) { return i; });
  const ValueId t =
      reduce(graph, Op::Sum, one, graph.constant(2), [&](ValueId j) { return graph.add(Op::Multiply, {s, j}); });
  graph.roots = {graph.add(Op::Add, {graph.add(Op::Multiply, {s, s}), t})};
  expect_value(graph, {}, spread(36 + 18), "sum of sums");
}

TEST(Reduction, InABranchThatIsNotTakenDoesNotRun) {
  // p < 0 ? (sum over 65 535 values of sums over 65 535 values) : 1 ends at once for p = 1.
  Graph graph;
  const ValueId one = graph.constant(1), many = graph.constant(65535);
  const ValueId p = real_parameter(graph, 0);
  const ValueId sum = reduce(graph, Op::Sum, one, many, [&](ValueId i) {
    return reduce(graph, Op::Sum, one, many, [&](ValueId j) { return graph.add(Op::Multiply, {i, j}); });
  });
  graph.roots = {graph.add(Op::Select, {graph.add(Op::Less, {p, graph.constant(0)}), sum, one})};
  expect_value(graph, {spread(1)}, spread(1), "not taken");
}

TEST(Reduction, EndsWithNanWhereNestingWouldRunForDays) {
  Graph graph;
  const ValueId one = graph.constant(1), many = graph.constant(65535);
  graph.roots = {reduce(graph, Op::Sum, one, many, [&](ValueId i) {
    return reduce(graph, Op::Sum, one, many, [&](ValueId j) {
      return reduce(graph, Op::Sum, one, many,
                    [&](ValueId k) { return graph.add(Op::Add, {i, graph.add(Op::Add, {j, k})}); });
    });
  })};
  EXPECT_TRUE(std::isnan(ReferenceEvaluator(graph).evaluate({}, {})[0]));
  EXPECT_TRUE(std::isnan(evaluate_batch(BatchEvaluator(graph), {Geometry{}})[0][0]));
}

}  // namespace
}  // namespace texbrdf::eval
