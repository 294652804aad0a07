#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "ir/passes/direction_values.h"
#include "ir/passes/passes.h"
#include "ir/passes/rewrite.h"

namespace texbrdf::ir {

namespace {

constexpr std::array kPolarAngles = {Convention::ThetaI, Convention::ThetaO, Convention::ThetaH, Convention::ThetaD};
constexpr std::array kAzimuths = {Convention::PhiI, Convention::PhiO, Convention::PhiH};

template <std::size_t N>
bool is_one_of(const Value& value, const std::array<Convention, N>& set) {
  return value.op == Op::Convention &&
         std::find(set.begin(), set.end(), static_cast<Convention>(value.index)) != set.end();
}

bool is_trigonometric(Op op) {
  return op == Op::Cos || op == Op::Sin || op == Op::Tan;
}

/// Finds the values that are a convention's angle, or sums, differences, negatives and doubles of such, and that a
/// cosine, sine or tangent is taken of: addition theorems reach them without an inverse function.
class AngleFinder {
 public:
  explicit AngleFinder(const Graph& graph) : graph_(graph), is_angle_(graph.size()), needed_(graph.size()) {
    for (uint32_t i = 0; i < graph.size(); ++i) is_angle_[i] = is_angle({i});
    for (uint32_t i = graph.size(); i-- > 0;) mark_operands({i});
  }

  bool is_needed(ValueId id) const { return needed_[id.value]; }
  bool is_expanded(ValueId id) const {
    return is_trigonometric(graph_.at(id).op) && is_angle_[graph_.operand(id, 0).value];
  }
  /// The operand that 2 is multiplied by, where `id` is such a product.
  std::optional<uint32_t> doubled_operand(ValueId id) const {
    if (graph_.at(id).op != Op::Multiply) return std::nullopt;
    for (uint32_t side = 0; side < 2; ++side) {
      const Value& factor = graph_.at(graph_.operand(id, side));
      if (factor.op == Op::Constant && factor.constant == 2) return 1 - side;
    }
    return std::nullopt;
  }

 private:
  bool is_angle(ValueId id) const {
    const Value& value = graph_.at(id);
    if (is_one_of(value, kPolarAngles) || is_one_of(value, kAzimuths)) return true;
    if (const auto side = doubled_operand(id)) return is_angle_[graph_.operand(id, *side).value];
    if (value.op != Op::Negate && value.op != Op::Add && value.op != Op::Subtract) return false;
    const auto operands = graph_.operands(id);
    return std::all_of(operands.begin(), operands.end(), [this](ValueId operand) { return is_angle_[operand.value]; });
  }

  void mark_operands(ValueId id) {
    if (!is_expanded(id) && !needed_[id.value]) return;
    for (const ValueId operand : graph_.operands(id)) {
      if (is_angle_[operand.value]) needed_[operand.value] = true;
    }
  }

  const Graph& graph_;
  std::vector<bool> is_angle_;
  std::vector<bool> needed_;
};

/// Cosine and sine of an angle, in the new graph.
struct CosineSine {
  ValueId cosine;
  ValueId sine;
};

class AngleExpander {
 public:
  explicit AngleExpander(const Graph& graph) : graph_(graph), angles_(graph) {}

  Graph run() {
    return rewrite(graph_, [this](Graph& result, ValueId id, std::span<const ValueId> operands) {
      if (angles_.is_expanded(id)) return of_angle(result, graph_.at(id).op, known_.at(graph_.operand(id, 0)));
      if (angles_.is_needed(id)) known_.emplace(id, expand(result, id, operands));
      return result.copy(graph_.at(id), operands);
    });
  }

 private:
  static ValueId of_angle(Graph& result, Op op, const CosineSine& angle) {
    if (op == Op::Cos) return angle.cosine;
    if (op == Op::Sin) return angle.sine;
    return result.add(Op::Divide, {angle.sine, angle.cosine});
  }

  CosineSine expand(Graph& result, ValueId id, std::span<const ValueId> operands) const {
    const Value& value = graph_.at(id);
    if (is_one_of(value, kPolarAngles)) {
      const ValueId cosine = clamped_cosine(result, operands[0], operands[1]);
      return {cosine, sine_of_polar_angle(result, cosine)};
    }
    if (is_one_of(value, kAzimuths)) {
      const Azimuth azimuth = azimuth_of(result, operands[0], operands[1], operands[2]);
      return {azimuth.cosine, azimuth.sine};
    }
    if (const auto side = angles_.doubled_operand(id)) {
      const CosineSine& half = known_.at(graph_.operand(id, *side));
      return sum(result, half, half);
    }
    const CosineSine& first = known_.at(graph_.operand(id, 0));
    if (value.op == Op::Negate) return negative(result, first);
    const CosineSine& second = known_.at(graph_.operand(id, 1));
    return value.op == Op::Add ? sum(result, first, second) : difference(result, first, second);
  }

  static CosineSine negative(Graph& result, const CosineSine& a) {
    return {a.cosine, result.add(Op::Negate, {a.sine})};
  }

  static CosineSine sum(Graph& result, const CosineSine& a, const CosineSine& b) {
    return combine(result, a, b, Op::Subtract, Op::Add);
  }

  static CosineSine difference(Graph& result, const CosineSine& a, const CosineSine& b) {
    return combine(result, a, b, Op::Add, Op::Subtract);
  }

  static CosineSine combine(Graph& result, const CosineSine& a, const CosineSine& b, Op of_cosine, Op of_sine) {
    const ValueId cosines = result.add(Op::Multiply, {a.cosine, b.cosine});
    const ValueId sines = result.add(Op::Multiply, {a.sine, b.sine});
    const ValueId first_sine = result.add(Op::Multiply, {a.sine, b.cosine});
    const ValueId second_sine = result.add(Op::Multiply, {a.cosine, b.sine});
    return {result.add(of_cosine, {cosines, sines}), result.add(of_sine, {first_sine, second_sine})};
  }

  const Graph& graph_;
  AngleFinder angles_;
  std::map<ValueId, CosineSine> known_;
};

}  // namespace

Graph angles_to_dot_products(const Graph& graph) {
  return AngleExpander(graph).run();
}

}  // namespace texbrdf::ir
