#include "emit/directions.h"

#include <algorithm>
#include <array>
#include <vector>

#include "emit/merge.h"
#include "ir/passes/direction_values.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::emit {
namespace {

using ir::Graph;
using ir::Op;
using ir::ValueId;

/// Values as the pass angles_to_dot_products makes them, to be recognised by being equal.
class DirectionValues {
 public:
  Graph take() { return std::move(graph_); }
  const std::vector<std::string>& names() const { return names_; }

  void polar_angle(Convention angle) {
    std::string name(convention_entry(angle).symbol);
    auto [a, b] = std::array{operand(angle, 0), operand(angle, 1)};
    ValueId cosine = ir::clamped_cosine(graph_, a, b);
    ValueId sine = ir::sine_of_polar_angle(graph_, cosine);
    add(name, graph_.add(Op::Arccos, {cosine}));
    add("cos_" + name, cosine);
    add("sin_" + name, sine);
    add("tan_" + name, graph_.add(Op::Divide, {sine, cosine}));
  }

  void azimuth(Convention angle) {
    std::string name(convention_entry(angle).symbol);
    ir::Azimuth azimuth = ir::azimuth_of(graph_, operand(angle, 0), operand(angle, 1), operand(angle, 2));
    ValueId is_zero = graph_.operand(azimuth.cosine, 0);
    add("radius_" + name.substr(name.find('_') + 1), graph_.operand(is_zero, 0));
    add("cos_" + name, azimuth.cosine);
    add("sin_" + name, azimuth.sine);
    add("tan_" + name, graph_.add(Op::Divide, {azimuth.sine, azimuth.cosine}));
  }

 private:
  ValueId operand(Convention angle, std::size_t index) {
    Convention id = convention_entry(angle).operands[index];
    std::vector<ValueId> operands;
    for (Convention part : convention_entry(id).operands) operands.push_back(graph_.convention(part));
    return graph_.convention(id, operands);
  }
  void add(std::string name, ValueId value) {
    names_.push_back(std::move(name));
    graph_.roots.push_back(value);
  }

  Graph graph_;
  std::vector<std::string> names_;
};

constexpr std::array kPolarAngles{Convention::ThetaI, Convention::ThetaO, Convention::ThetaH, Convention::ThetaD};
constexpr std::array kAzimuths{Convention::PhiI, Convention::PhiO, Convention::PhiH};

Graph with_angles_as_arccosines(const Graph& graph) {
  return ir::rewrite(graph, [&](Graph& result, ValueId id, std::span<const ValueId> operands) {
    const ir::Value& value = graph.at(id);
    bool is_angle = value.op == Op::Convention &&
                    std::ranges::find(kPolarAngles, static_cast<Convention>(value.index)) != kPolarAngles.end();
    if (!is_angle) return result.copy(value, operands);
    return result.add(Op::Arccos, {ir::clamped_cosine(result, operands[0], operands[1])});
  });
}

}  // namespace

GraphWithDirections name_directions(const Graph& graph, bool expand_angles) {
  DirectionValues directions;
  for (Convention angle : kPolarAngles) directions.polar_angle(angle);
  for (Convention angle : kAzimuths) directions.azimuth(angle);

  std::vector<std::string> names = directions.names();
  Graph known = directions.take();
  Merger merger;
  merger.append(expand_angles ? with_angles_as_arccosines(graph) : graph);
  std::vector<ValueId> images = merger.append(known);
  GraphWithDirections result{.graph = merger.take(), .names = {}};
  for (std::size_t i = 0; i < names.size(); ++i) result.names.emplace(images[known.roots[i].value], names[i]);
  result.graph.roots.resize(graph.roots.size());
  return result;
}

}  // namespace texbrdf::emit
