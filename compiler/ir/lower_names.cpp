#include <algorithm>
#include <array>

#include "ir/lowering.h"
#include "source/internal_error.h"
#include "syntax/control_words.h"

namespace texbrdf::ir {

ValueId Lowering::name(NodeId node) {
  const auto& calls = checked_.implied_calls;
  const auto call = std::ranges::lower_bound(calls, node, {}, &ImpliedCall::node);
  if (call != calls.end() && call->node == node) return implied_call(*call);
  return value_of({referent(node), type(node)});
}

ValueId Lowering::value_of(const TypedReferent& meaning) {
  const Referent& target = meaning.referent;
  switch (target.kind) {
    case Referent::Kind::Definition:
      return graph_.leaf(Op::Reference, meaning.type, target.index);
    case Referent::Kind::Derived:
      return derived(checked_.derived[target.index]);
    case Referent::Kind::Convention:
      return convention(static_cast<Convention>(target.index));
    case Referent::Kind::Parameter:
      return parameter(target.index);
    case Referent::Kind::Angle:
      return angle(angle_of_parameter(target).kind, formal(angle_of_parameter(target).position));
    case Referent::Kind::Bound:
      return bound_[target.index];
    case Referent::Kind::BoundAngle:
      return angle(angle_of_parameter(target).kind, bound_[angle_of_parameter(target).position]);
    case Referent::Kind::Indexed:
      return graph_.leaf(Op::Reference, meaning.type, name_at(checked_.indexed[target.index]).value);
    case Referent::Kind::None:
      return add_constant(graph_, 0, meaning.type);
    case Referent::Kind::Derivative:
    case Referent::Kind::Transposition:
    case Referent::Kind::Builtin:
      break;
  }
  throw InternalError("a name that refers to nothing in a sound definition");
}

ValueId Lowering::derived(const DerivedNumber& number) {
  const ValueId vector = value_of(number.vector);
  if (number.kind == DerivedNumber::Kind::PolarAngle) return angle(Convention::ThetaI, vector);
  if (number.kind == DerivedNumber::Kind::Azimuth) return angle(Convention::PhiI, vector);
  if (number.kind == DerivedNumber::Kind::PositivePart) return graph_.add(Op::Max, {graph_.constant(0), vector});
  if (number.kind == DerivedNumber::Kind::Entry) return entry(vector, number.axis);
  constexpr Convention kAxes[] = {Convention::Tangent, Convention::Bitangent, Convention::Normal};
  return graph_.add(Op::Dot, {vector, convention(kAxes[number.axis])});
}

/// The angle where the argument is its cosine.
ValueId Lowering::parameter(uint32_t position) {
  const Command function = checked_.parameters[position].function;
  if (function == Command::None) return formal(position);
  return graph_.add(function_op(inverse_of(function)), {formal(position)});
}

ValueId Lowering::formal(uint32_t position) {
  const Type type = checked_.parameters[position].type;
  const uint32_t first = formals_[position];
  if (!is_aggregate(type)) return graph_.leaf(Op::Formal, type, first);
  std::vector<ValueId> entries;
  for (uint32_t i = 0; i < type_components(type); ++i) {
    entries.push_back(graph_.leaf(Op::Formal, Type::Real, first + i));
  }
  return value_of_matrix({type_shape(type), entries}, type);
}

ValueId Lowering::angle(Convention kind, ValueId direction) {
  if (kind == Convention::ThetaI) {
    return graph_.convention(kind, std::array{convention(Convention::Normal), direction});
  }
  const ValueId tangent = convention(Convention::Tangent);
  return graph_.convention(kind, std::array{tangent, convention(Convention::Bitangent), direction});
}

/// With the indices that the sums around it have now.
NameId Lowering::name_at(const IndexedName& indexed) const {
  std::size_t position = 0;
  for (std::size_t i = 0; i < indexed.bound.size(); ++i) {
    position = position * indexed.counts[i] + terms_.at(indexed.bound[i]);
  }
  return indexed.names[position];
}

/// At most three levels deep: \theta_h is made of \vec{h}, which is made of the two directions.
ValueId Lowering::convention(Convention id) {
  ValueId& known = conventions_[static_cast<std::size_t>(id)];
  if (known.valid()) return known;
  if (const auto position = shadowing_parameter(id)) return known = parameter(*position);
  std::vector<ValueId> operands;
  for (const Convention operand : convention_entry(id).operands) operands.push_back(convention(operand));
  return known = graph_.convention(id, operands);
}

std::optional<uint32_t> Lowering::shadowing_parameter(Convention id) const {
  for (uint32_t i = 0; i < checked_.parameters.size(); ++i) {
    const auto& shadowed = checked_.parameters[i].shadowed;
    if (std::find(shadowed.begin(), shadowed.end(), id) != shadowed.end()) return i;
  }
  return std::nullopt;
}

}  // namespace texbrdf::ir
