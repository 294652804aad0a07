// Conventions by their formulas, in the standard frame and in others.

#include "ir/passes/passes.h"
#include "support/evaluation.h"
#include "support/random.h"

namespace texbrdf::eval {
namespace {

using ir::Graph;
using ir::ValueId;

constexpr double kPi = 3.141592653589793;

/// One root for each convention, in the order of the table.
Graph all_conventions() {
  Graph graph;
  for (const ConventionEntry& entry : conventions()) {
    std::vector<ValueId> operands;
    for (const Convention operand : entry.operands) {
      operands.push_back(graph.roots[static_cast<std::size_t>(operand)]);
    }
    graph.roots.push_back(graph.convention(entry.id, operands));
  }
  return graph;
}

double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triple normalise(const Triple& a) {
  const double length = std::sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triple random_direction(test::Random& random) {
  return normalise({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
}

Geometry random_geometry(test::Random& random) {
  Geometry g{.light = random_direction(random), .view = random_direction(random)};
  g.normal = random_direction(random);
  g.tangent = normalise(cross(random_direction(random), g.normal));
  g.bitangent = cross(g.normal, g.tangent);
  return g;
}

Triple expected_value(Convention id, const Geometry& g) {
  const Triple& l = g.light;
  const Triple& v = g.view;
  const Triple h = normalise({l[0] + v[0], l[1] + v[1], l[2] + v[2]});
  const auto angle = [](double cosine) {
    const double a = std::acos(std::min(1.0, std::max(-1.0, cosine)));
    return Triple{a, a, a};
  };
  const auto azimuth = [&](const Triple& d) {
    const double a = std::atan2(dot(d, g.bitangent), dot(d, g.tangent));
    return Triple{a, a, a};
  };
  switch (id) {
    case Convention::OmegaI:
      return l;
    case Convention::OmegaO:
      return v;
    case Convention::Normal:
      return g.normal;
    case Convention::Tangent:
      return g.tangent;
    case Convention::Bitangent:
      return g.bitangent;
    case Convention::Half:
      return h;
    case Convention::ThetaI:
      return angle(dot(g.normal, l));
    case Convention::ThetaO:
      return angle(dot(g.normal, v));
    case Convention::PhiI:
      return azimuth(l);
    case Convention::PhiO:
      return azimuth(v);
    case Convention::PhiH:
      return azimuth(h);
    case Convention::ThetaH:
      return angle(dot(g.normal, h));
    case Convention::ThetaD:
      return angle(dot(l, h));
    case Convention::Pi:
      return {kPi, kPi, kPi};
    case Convention::Epsilon:
      return {1.192092896e-07, 1.192092896e-07, 1.192092896e-07};
    case Convention::Euler:
      return {std::exp(1.0), std::exp(1.0), std::exp(1.0)};
  }
  return {};
}

void expect_conventions(const Graph& graph, const std::vector<Geometry>& geometries, double tolerance) {
  const ReferenceEvaluator reference(graph);
  const BatchEvaluator batch(graph);
  for (const ConventionEntry& entry : conventions()) {
    const auto root = static_cast<std::size_t>(entry.id);
    const std::vector<Triple> single = evaluate_batch(batch, geometries, {}, root);
    for (std::size_t i = 0; i < geometries.size(); ++i) {
      const Triple expected = expected_value(entry.id, geometries[i]);
      const Triple actual = reference.evaluate(geometries[i], {}, root);
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(actual[c], expected[c], tolerance) << entry.symbol;
        EXPECT_NEAR(single[i][c], expected[c], 2e-3) << entry.symbol;
      }
    }
  }
}

TEST(Conventions, HaveTheirFormulasInAnyFrame) {
  test::Random random(1);
  std::vector<Geometry> geometries;
  for (int i = 0; i < 500; ++i) geometries.push_back(random_geometry(random));
  expect_conventions(all_conventions(), geometries, 1e-12);
  expect_conventions(ir::expand_conventions(all_conventions()), geometries, 1e-12);
}

TEST(Conventions, AtTheEdgesOfTheirDomains) {
  const Triple x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1};
  const auto negative = [](const Triple& a) { return Triple{-a[0], -a[1], -a[2]}; };
  const auto at = [](Convention id, const Geometry& g) {
    return ReferenceEvaluator(all_conventions()).evaluate(g, {}, static_cast<std::size_t>(id))[0];
  };
  const Triple too_long = {0, 0, 1 + 1e-12};
  EXPECT_EQ(at(Convention::ThetaI, {.light = too_long, .view = z}), 0);
  EXPECT_EQ(at(Convention::ThetaI, {.light = negative(too_long), .view = z}), kPi);
  EXPECT_EQ(at(Convention::PhiI, {.light = z, .view = z}), 0);
  EXPECT_EQ(at(Convention::PhiI, {.light = negative(x), .view = z}), kPi);
  EXPECT_EQ(at(Convention::PhiI, {.light = {-1, -0.0, 0}, .view = z}), kPi);
  EXPECT_EQ(at(Convention::PhiO, {.light = z, .view = negative(y)}), -kPi / 2);
  EXPECT_TRUE(std::isnan(at(Convention::Half, {.light = x, .view = negative(x)})));
  EXPECT_TRUE(std::isnan(at(Convention::ThetaH, {.light = x, .view = negative(x)})));
}

}  // namespace
}  // namespace texbrdf::eval
