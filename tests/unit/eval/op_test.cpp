// Every op of ops.def by value: the double evaluator exactly as the table says, the batch on every backend within
// rounding.

#include <set>

#include "support/evaluation.h"

namespace texbrdf::eval {
namespace {

using ir::Graph;
using ir::Op;
using ir::ValueId;

constexpr double kPi = 3.141592653589793;

struct RealCase {
  Op op;
  std::vector<double> operands;
  double expected;
};

const std::vector<RealCase> kRealCases = {
    {Op::Negate, {2}, -2},
    {Op::Add, {2, 3}, 5},
    {Op::Subtract, {2, 3}, -1},
    {Op::Multiply, {2, 3}, 6},
    {Op::Divide, {3, 2}, 1.5},
    {Op::Divide, {1, 0}, kInfinity},
    {Op::Divide, {-1, 0}, -kInfinity},
    {Op::Divide, {0, 0}, kNotANumber},
    {Op::Min, {1, 2}, 1},
    {Op::Min, {2, 1}, 1},
    {Op::Min, {kNotANumber, 1}, kNotANumber},
    {Op::Min, {1, kNotANumber}, kNotANumber},
    {Op::Min, {-kInfinity, 1}, -kInfinity},
    {Op::Max, {1, 2}, 2},
    {Op::Max, {2, 1}, 2},
    {Op::Max, {kNotANumber, 1}, kNotANumber},
    {Op::Max, {1, kNotANumber}, kNotANumber},
    {Op::Max, {-kInfinity, 1}, 1},
    // Power: sign and zero follow repeated multiplication where the exponent is an integer.
    {Op::Power, {2, 10}, 1024},
    {Op::Power, {2, -1}, 0.5},
    {Op::Power, {-2, 3}, -8},
    {Op::Power, {-2, 2}, 4},
    {Op::Power, {-2, -3}, -0.125},
    {Op::Power, {-2, -2}, 0.25},
    {Op::Power, {-2, 0}, 1},
    {Op::Power, {-1, 8388607}, -1},
    {Op::Power, {-1, 8388608}, 1},
    {Op::Power, {-1, 16777215}, -1},
    {Op::Power, {-1, 16777216}, 1},
    {Op::Power, {-2, 0.5}, kNotANumber},
    {Op::Power, {-8, 1.0 / 3}, kNotANumber},
    {Op::Power, {4, 0.5}, 2},
    {Op::Power, {0, 0}, 1},
    {Op::Power, {-0.0, 0}, 1},
    {Op::Power, {0, 3}, 0},
    {Op::Power, {0, 0.5}, 0},
    {Op::Power, {0, -1}, kInfinity},
    {Op::Power, {-0.0, -1}, kInfinity},
    {Op::Power, {0, -0.5}, kInfinity},
    {Op::Power, {kNotANumber, 0}, 1},
    {Op::Power, {kNotANumber, 2}, kNotANumber},
    {Op::Power, {2, kNotANumber}, kNotANumber},
    {Op::Power, {1, kNotANumber}, kNotANumber},
    {Op::Power, {kInfinity, 2}, kInfinity},
    {Op::Power, {-kInfinity, 3}, -kInfinity},
    {Op::Power, {-kInfinity, 0.5}, kNotANumber},
    {Op::Power, {kInfinity, -1}, 0},
    {Op::Power, {2, kInfinity}, kInfinity},
    {Op::Power, {0.5, kInfinity}, 0},
    {Op::Power, {-2, kInfinity}, kNotANumber},
    {Op::Root, {16, 2}, 4},
    {Op::Root, {27, 3}, 3},
    {Op::Root, {-27, 3}, -3},
    {Op::Root, {-16, 4}, kNotANumber},
    {Op::Root, {-16, 2}, kNotANumber},
    {Op::Root, {-16, 2.5}, kNotANumber},
    {Op::Root, {0, 3}, 0},
    {Op::Root, {32, 5}, 2},
    {Op::Root, {16, -2}, 0.25},
    {Op::Root, {-8, -3}, -0.5},
    {Op::Root, {0, -3}, kInfinity},
    {Op::Root, {2, 0}, kNotANumber},
    {Op::Root, {2, kNotANumber}, kNotANumber},
    {Op::Sqrt, {2}, 1.4142135623730951},
    {Op::Sqrt, {0}, 0},
    {Op::Sqrt, {-1e-9}, kNotANumber},
    {Op::Exp, {1}, 2.718281828459045},
    {Op::Exp, {-1000}, 0},
    {Op::Exp, {1000}, kInfinity},
    {Op::Ln, {2}, 0.6931471805599453},
    {Op::Ln, {0}, -kInfinity},
    {Op::Ln, {-1}, kNotANumber},
    {Op::Sin, {1}, 0.8414709848078965},
    {Op::Sin, {kInfinity}, kNotANumber},
    {Op::Cos, {1}, 0.5403023058681398},
    {Op::Tan, {1}, 1.5574077246549023},
    {Op::Arcsin, {0.5}, 0.5235987755982989},
    {Op::Arcsin, {1 + 0.9e-6}, kPi / 2},
    {Op::Arcsin, {-1 - 0.9e-6}, -kPi / 2},
    {Op::Arcsin, {1 + 1.2e-6}, kNotANumber},
    {Op::Arcsin, {kNotANumber}, kNotANumber},
    {Op::Arccos, {0.5}, 1.0471975511965979},
    {Op::Arccos, {1 + 0.9e-6}, 0},
    {Op::Arccos, {-1 - 0.9e-6}, kPi},
    {Op::Arccos, {-1 - 1.2e-6}, kNotANumber},
    {Op::Arctan, {1}, kPi / 4},
    {Op::Arctan, {kInfinity}, kPi / 2},
    {Op::Arctan2, {1, 1}, kPi / 4},
    {Op::Arctan2, {1, -1}, 3 * kPi / 4},
    {Op::Arctan2, {-1, -1}, -3 * kPi / 4},
    {Op::Arctan2, {0, -1}, kPi},
    {Op::Arctan2, {-0.0, -1}, kPi},
    {Op::Arctan2, {0, 0}, 0},
    {Op::Arctan2, {0, -0.0}, 0},
    {Op::Arctan2, {-0.0, -0.0}, 0},
    {Op::Sinh, {1}, 1.1752011936438014},
    {Op::Cosh, {1}, 1.5430806348152437},
    {Op::Tanh, {1}, 0.7615941559557649},
};

std::string describe(const RealCase& c) {
  std::string text(ir::op_entry(c.op).printed);
  for (const double operand : c.operands) text += " " + std::to_string(operand);
  return text;
}

/// op(parameters…): nothing is known before the evaluator runs.
Graph graph_of(Op op, std::size_t operands) {
  Graph graph;
  std::vector<ValueId> ids;
  for (uint32_t i = 0; i < operands; ++i) ids.push_back(graph.leaf(Op::Parameter, Type::Real, i));
  graph.roots = {graph.add(op, ids)};
  return graph;
}

/// op(components of the light vector…): what depends on the geometry takes another way through the tape.
Graph graph_of_light(Op op, std::size_t operands) {
  Graph graph;
  const ValueId light = graph.convention(Convention::OmegaI);
  std::vector<ValueId> ids;
  for (uint32_t i = 0; i < operands; ++i) ids.push_back(graph.add(Op::Component, {light}, i));
  graph.roots = {graph.add(op, ids)};
  return graph;
}

std::vector<Triple> as_parameters(const std::vector<double>& numbers) {
  std::vector<Triple> parameters;
  for (const double x : numbers) parameters.push_back({x, 0, 0});
  return parameters;
}

Geometry as_light(const std::vector<double>& numbers) {
  Geometry geometry{.light = {}, .view = {}};
  std::copy(numbers.begin(), numbers.end(), geometry.light.begin());
  return geometry;
}

TEST(Op, OfRealsMeansWhatTheTableSays) {
  for (const RealCase& c : kRealCases) {
    const ReferenceEvaluator evaluator(graph_of(c.op, c.operands.size()));
    const Triple actual = evaluator.evaluate({}, as_parameters(c.operands));
    for (const double component : actual) {
      EXPECT_PRED4(is_close, component, c.expected, 4e-16, 0) << describe(c);
    }
  }
}

TEST(Op, OfRealsIsTheSameInBatches) {
  for (const Backend& backend : backends()) {
    for (const RealCase& c : kRealCases) {
      const BatchEvaluator uniform(graph_of(c.op, c.operands.size()), backend.set, *backend.functions);
      const Triple of_parameters = evaluate_batch(uniform, {Geometry{}}, as_parameters(c.operands))[0];
      EXPECT_PRED4(is_close, of_parameters[0], c.expected, 3e-7, 1e-7) << describe(c) << " on " << backend.name;
      const BatchEvaluator varying(graph_of_light(c.op, c.operands.size()), backend.set, *backend.functions);
      const Triple of_light = evaluate_batch(varying, {as_light(c.operands)})[0];
      EXPECT_PRED4(is_close, of_light[1], c.expected, 3e-7, 1e-7) << describe(c) << " on " << backend.name;
    }
  }
}

/// op(parameters…), of which those in `triples` are colours, and all that it takes component by component.
Graph graph_of_colours(Op op, std::size_t operands, const std::set<uint32_t>& triples) {
  Graph graph;
  std::vector<ValueId> ids;
  for (uint32_t i = 0; i < operands; ++i) {
    ids.push_back(graph.leaf(Op::Parameter, triples.contains(i) ? Type::Colour : Type::Real, i));
  }
  graph.roots = {graph.add(op, ids)};
  return graph;
}

TEST(Op, OfColoursIsThatOfTheirComponents) {
  constexpr double kOther = 0.75;
  for (const RealCase& c : kRealCases) {
    if (c.op == Op::Arctan2) continue;
    std::vector<std::set<uint32_t>> choices = {{0}};
    if (c.operands.size() == 2) choices = {{0}, {1}, {0, 1}};
    for (const std::set<uint32_t>& triples : choices) {
      std::vector<Triple> parameters;
      std::vector<double> others = c.operands;
      for (uint32_t i = 0; i < c.operands.size(); ++i) {
        const double x = c.operands[i];
        if (triples.contains(i)) others[i] = kOther;
        parameters.push_back(triples.contains(i) ? Triple{x, kOther, x} : Triple{x, 0, 0});
      }
      const Graph graph = graph_of_colours(c.op, c.operands.size(), triples);
      ASSERT_TRUE(is_triple(graph.at(graph.roots[0]).type)) << describe(c);
      const Triple exact = ReferenceEvaluator(graph).evaluate({}, parameters);
      const ReferenceEvaluator of_reals(graph_of(c.op, c.operands.size()));
      const Triple expected = {c.expected, of_reals.evaluate({}, as_parameters(others))[0], c.expected};
      for (std::size_t i = 0; i < 3; ++i) EXPECT_PRED4(is_close, exact[i], expected[i], 4e-16, 0) << describe(c);
      for (const Backend& backend : backends()) {
        const BatchEvaluator batch(graph, backend.set, *backend.functions);
        const Triple single = evaluate_batch(batch, {Geometry{}}, parameters)[0];
        for (std::size_t i = 0; i < 3; ++i) {
          EXPECT_PRED4(is_close, single[i], expected[i], 3e-7, 1e-7) << describe(c) << " on " << backend.name;
        }
      }
    }
  }
}

/// Reals of all sizes and signs, both zeros, infinities, NaN.
std::vector<double> interesting_numbers() {
  std::vector<double> numbers = {0.0, kInfinity, kNotANumber};
  for (const double x : {1e-30, 0.001, 0.3, 0.5, 1.0, 1.0000001, 1.5, 2.0, 3.0, 4.0, 7.0, 12.5, 100.0, 1e6, 1e30}) {
    numbers.push_back(x);
  }
  const std::size_t positive = numbers.size();
  for (std::size_t i = 0; i < positive; ++i) numbers.push_back(-numbers[i]);
  return numbers;
}

/// |x|^y by exp and ln in extended precision.
long double magnitude(long double x, long double y) {
  return std::exp(y * std::log(std::abs(x)));
}

/// Language.md section 6, written from its words.
double expected_power(double x, double y) {
  if (std::isnan(y)) return kNotANumber;
  if (y == 0) return 1;
  if (std::isnan(x)) return kNotANumber;
  if (x == 0) return y > 0 ? 0 : kInfinity;
  const bool integer = std::isfinite(y) && std::floor(y) == y;
  if (x < 0 && !integer) return kNotANumber;
  if (integer && std::abs(y) <= 16) {
    long double product = 1;
    for (int i = 0; i < static_cast<int>(std::abs(y)); ++i) product *= static_cast<long double>(x);
    return static_cast<double>(y > 0 ? product : 1 / product);
  }
  if (std::abs(x) == 1) return x > 0 || std::fmod(y, 2) == 0 ? 1 : -1;
  const long double size = magnitude(x, y);
  return static_cast<double>(x < 0 && std::fmod(y, 2) != 0 ? -size : size);
}

double expected_root(double x, double n) {
  if (std::isnan(n) || n == 0) return kNotANumber;
  if (std::isinf(n)) return x < 0 ? kNotANumber : 1;  // x^0
  if (std::isnan(x)) return kNotANumber;
  const bool odd = std::floor(n) == n && std::fmod(n, 2) != 0;
  if (x < 0 && !odd) return kNotANumber;
  if (x == 0) return n > 0 ? 0 : kInfinity;
  const double size = static_cast<double>(magnitude(x, 1 / static_cast<long double>(n)));
  return x < 0 ? -size : size;
}

struct BinaryOp {
  Op op;
  double (*expected)(double, double);
};

void check_against(BinaryOp op) {
  const ReferenceEvaluator evaluator(graph_of(op.op, 2));
  for (const double x : interesting_numbers()) {
    for (const double y : interesting_numbers()) {
      const double actual = evaluator.evaluate({}, as_parameters({x, y}))[0];
      EXPECT_PRED4(is_close, actual, op.expected(x, y), 1e-13, 1e-300)
          << ir::op_entry(op.op).printed << " of " << x << " and " << y;
    }
  }
}

TEST(Op, PowerIsRepeatedMultiplication) {
  check_against({Op::Power, expected_power});
}

TEST(Op, RootIsThePowerOfTheReciprocal) {
  check_against({Op::Root, expected_root});
}

TEST(Op, PowerAndRootAreTheSameInBatches) {
  const std::vector<double> numbers = interesting_numbers();
  std::vector<Geometry> pairs;
  for (const double x : numbers) {
    for (const double y : numbers) pairs.push_back(as_light({static_cast<float>(x), static_cast<float>(y)}));
  }
  for (const BinaryOp& op : {BinaryOp{Op::Power, expected_power}, BinaryOp{Op::Root, expected_root}}) {
    for (const Backend& backend : backends()) {
      const BatchEvaluator evaluator(graph_of_light(op.op, 2), backend.set, *backend.functions);
      const std::vector<Triple> actual = evaluate_batch(evaluator, pairs);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        const auto expected = static_cast<float>(op.expected(pairs[i].light[0], pairs[i].light[1]));
        // An exponent of 100 makes a hundred times the rounding error of a root's reciprocal; below 1e-37 is denormal.
        EXPECT_PRED4(is_close, actual[i][0], expected, 1e-5, 1e-37)
            << ir::op_entry(op.op).printed << " of " << pairs[i].light[0] << " and " << pairs[i].light[1] << " on "
            << backend.name;
      }
    }
  }
}

TEST(Op, ArithmeticIsBitForBitTheSameOnEveryInstructionSet) {
  std::vector<Geometry> pairs;
  for (const double x : interesting_numbers()) {
    for (const double y : interesting_numbers()) pairs.push_back(as_light({x, y}));
  }
  for (const Op op : {Op::Add, Op::Subtract, Op::Multiply, Op::Divide, Op::Min, Op::Max}) {
    const std::vector<Triple> expected =
        evaluate_batch(BatchEvaluator(graph_of_light(op, 2), InstructionSet::Sse2), pairs);
    for (const Backend& backend : backends()) {
      const std::vector<Triple> actual = evaluate_batch(BatchEvaluator(graph_of_light(op, 2), backend.set), pairs);
      for (std::size_t i = 0; i < pairs.size(); ++i) {
        EXPECT_PRED4(is_close, actual[i][0], expected[i][0], 0, 0) << ir::op_entry(op).printed << backend.name;
      }
    }
  }
}

/// A triple-valued graph, its expected value, and a name.
struct VectorCase {
  std::string name;
  Graph graph;
  Triple expected;
};

std::vector<VectorCase> vector_cases() {
  std::vector<VectorCase> cases;
  const auto add = [&](std::string name, Triple expected, auto build) {
    Graph graph;
    graph.roots = {build(graph)};
    cases.push_back({std::move(name), std::move(graph), expected});
  };
  const auto vector = [](Graph& g, double x, double y, double z) {
    return g.add(Op::MakeVector, {g.constant(x), g.constant(y), g.constant(z)});
  };
  const auto light = [](Graph& g) { return g.convention(Convention::OmegaI); };
  const auto view = [](Graph& g) { return g.convention(Convention::OmegaO); };
  // L = (1, 2, 3), V = (4, -5, 6).
  add("vector", {7, 8, 9}, [&](Graph& g) { return vector(g, 7, 8, 9); });
  add("component 0", {1, 1, 1}, [&](Graph& g) { return g.add(Op::Component, {light(g)}, 0); });
  add("component 2", {3, 3, 3}, [&](Graph& g) { return g.add(Op::Component, {light(g)}, 2); });
  add("vector of components", {6, 2, 2}, [&](Graph& g) {
    return g.add(Op::MakeVector,
                 {g.add(Op::Component, {view(g)}, 2), g.add(Op::Component, {light(g)}, 1), g.constant(2)});
  });
  add("negate", {-1, -2, -3}, [&](Graph& g) { return g.add(Op::Negate, {light(g)}); });
  add("add", {5, -3, 9}, [&](Graph& g) { return g.add(Op::Add, {light(g), view(g)}); });
  add("subtract", {-3, 7, -3}, [&](Graph& g) { return g.add(Op::Subtract, {light(g), view(g)}); });
  add("multiply by components", {4, -10, 18}, [&](Graph& g) { return g.add(Op::Multiply, {light(g), view(g)}); });
  add("real times vector", {2, 4, 6}, [&](Graph& g) { return g.add(Op::Multiply, {g.constant(2), light(g)}); });
  add("vector times real", {2, 4, 6}, [&](Graph& g) { return g.add(Op::Multiply, {light(g), g.constant(2)}); });
  add("vector over real", {0.5, 1, 1.5}, [&](Graph& g) { return g.add(Op::Divide, {light(g), g.constant(2)}); });
  add("real over vector", {6, 3, 2}, [&](Graph& g) { return g.add(Op::Divide, {g.constant(6), light(g)}); });
  add("dot", {12, 12, 12}, [&](Graph& g) { return g.add(Op::Dot, {light(g), view(g)}); });
  add("cross", {27, 6, -13}, [&](Graph& g) { return g.add(Op::Cross, {light(g), view(g)}); });
  add("a component of a cross product", {6, 6, 6},
      [&](Graph& g) { return g.add(Op::Component, {g.add(Op::Cross, {light(g), view(g)})}, 1); });
  add("select a vector", {1, 2, 3}, [&](Graph& g) {
    const ValueId condition = g.add(Op::Less, {g.constant(1), g.add(Op::Component, {light(g)}, 1)});
    return g.add(Op::Select, {condition, light(g), view(g)});
  });
  return cases;
}

TEST(Op, OfVectorsWorksByComponents) {
  const Geometry geometry{.light = {1, 2, 3}, .view = {4, -5, 6}};
  for (const VectorCase& c : vector_cases()) {
    EXPECT_EQ(ReferenceEvaluator(c.graph).evaluate(geometry, {}), c.expected) << c.name;
    for (const Backend& backend : backends()) {
      EXPECT_EQ(evaluate_batch(BatchEvaluator(c.graph, backend.set, *backend.functions), {geometry})[0], c.expected)
          << c.name << " on " << backend.name;
    }
  }
}

struct TruthCase {
  std::string name;
  double a, b;
  double less, less_equal, equal;
};

TEST(Op, ComparisonsAndLogic) {
  const std::vector<TruthCase> cases = {{"less", 1, 2, 1, 1, 0},          {"greater", 2, 1, 0, 0, 0},
                                        {"equal", 2, 2, 0, 1, 1},         {"zeros", 0.0, -0.0, 0, 1, 1},
                                        {"nan", kNotANumber, 1, 0, 0, 0}, {"nan second", 1, kNotANumber, 0, 0, 0}};
  const auto indicator = [](Graph& graph, ValueId condition) {
    graph.roots.push_back(graph.add(Op::Select, {condition, graph.constant(1), graph.constant(0)}));
  };
  Graph graph;
  const ValueId light = graph.convention(Convention::OmegaI);
  const ValueId a = graph.add(Op::Component, {light}, 0);
  const ValueId b = graph.add(Op::Component, {light}, 1);
  const ValueId less = graph.add(Op::Less, {a, b});
  const ValueId less_equal = graph.add(Op::LessEqual, {a, b});
  const ValueId equal = graph.add(Op::Equal, {a, b});
  for (const ValueId condition : {less, less_equal, equal, graph.add(Op::Not, {less}),
                                  graph.add(Op::And, {less_equal, equal}), graph.add(Op::Or, {less, equal})}) {
    indicator(graph, condition);
  }
  for (const TruthCase& c : cases) {
    const std::vector<double> expected = {
        c.less, c.less_equal, c.equal, 1 - c.less, std::min(c.less_equal, c.equal), std::max(c.less, c.equal)};
    const Geometry geometry{.light = {c.a, c.b, 0}, .view = {}};
    for (std::size_t root = 0; root < expected.size(); ++root) {
      EXPECT_EQ(ReferenceEvaluator(graph).evaluate(geometry, {}, root)[0], expected[root]) << c.name << root;
      for (const Backend& backend : backends()) {
        const BatchEvaluator evaluator(graph, backend.set, *backend.functions);
        EXPECT_EQ(evaluate_batch(evaluator, {geometry}, {}, root)[0][0], expected[root]) << c.name << root;
      }
    }
  }
}

TEST(Op, ParametersAreReadByIndexAndType) {
  Graph graph;
  const ValueId colour = graph.leaf(Op::Parameter, Type::Colour, 1);
  graph.roots = {graph.add(Op::Multiply, {graph.leaf(Op::Parameter, Type::Real, 0), colour})};
  const std::vector<Triple> parameters = {{2, 100, 100}, {0.5, 1, 3}};
  const Triple expected = {1, 2, 6};
  EXPECT_EQ(ReferenceEvaluator(graph).evaluate({}, parameters), expected);
  for (const Backend& backend : backends()) {
    EXPECT_EQ(evaluate_batch(BatchEvaluator(graph, backend.set), {Geometry{}}, parameters)[0], expected);
  }
}

}  // namespace
}  // namespace texbrdf::eval
