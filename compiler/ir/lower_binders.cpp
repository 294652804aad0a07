#include <algorithm>
#include <array>
#include <limits>

#include "ir/lowering.h"
#include "syntax/relations.h"

namespace texbrdf::ir {

uint32_t Lowering::position_of(NodeId binder) const {
  const auto found = std::ranges::lower_bound(checked_.bound, binder, {}, &BoundName::node);
  return static_cast<uint32_t>(found - checked_.bound.begin());
}

/// The body of the binder where its name has the value.
ValueId Lowering::body_with(NodeId body, uint32_t position, ValueId bound) {
  bound_[position] = bound;
  const auto saved = conventions_;
  if (!checked_.bound[position].shadowed.empty()) follow(checked_.bound[position].shadowed, bound);
  const ValueId result = lower_tree(body, checked_.bound[position].first_node);
  conventions_ = saved;
  return result;
}

/// Conventions, and all that is made of them, follow what is bound.
void Lowering::follow(std::span<const Convention> shadowed, ValueId bound) {
  std::ranges::fill(conventions_, ValueId{});
  for (const Convention id : shadowed) conventions_[static_cast<std::size_t>(id)] = bound;
}

ValueId Lowering::sum(NodeId node) {
  const uint32_t position = position_of(node);
  const BoundName& bound = checked_.bound[position];
  if (bound.is_written_out) return written_sum(node, position);
  const NodeId range = block_.tree.child(node, 1);
  const uint32_t binder = graph_.new_binder();
  const ValueId variable = graph_.leaf(Op::BoundVariable, Type::Real, binder);
  const ValueId body = body_with(block_.tree.child(node, 2), position, variable);
  return graph_.add(is_product(node) ? Op::Product : Op::Sum, {child_value(range, 0), child_value(range, 1), body},
                    binder);
}

bool Lowering::is_product(NodeId node) const {
  return block_.token_text(block_.tree.node(node).token) == "\\prod";
}

ValueId Lowering::written_sum(NodeId node, uint32_t position) {
  const BoundName& bound = checked_.bound[position];
  const NodeId range = block_.tree.child(node, 1);
  const bool is_set = block_.tree.node(range).kind == NodeKind::Set;
  const std::size_t count = is_set ? block_.tree.node(range).child_count : bound.indices.size();
  const ValueId last = bound.is_open ? child_value(range, 1) : ValueId{};
  const Op op = is_product(node) ? Op::Multiply : Op::Add;
  ValueId total;
  for (std::size_t i = 0; i < count; ++i) {
    terms_[position] = i;
    const ValueId index = is_set ? child_value(range, static_cast<uint32_t>(i)) : graph_.constant(bound.indices[i]);
    const ValueId term = body_with(block_.tree.child(node, 2), position, index);
    if (!bound.is_open) {
      total = total.valid() ? graph_.add(op, {total, term}) : term;
      continue;
    }
    if (!total.valid()) total = add_constant(graph_, is_product(node) ? 1 : 0, graph_.at(term).type);
    total = graph_.add(Op::Select, {graph_.add(Op::LessEqual, {index, last}), graph_.add(op, {total, term}), total});
  }
  if (!bound.is_open) return total;
  // A document that asks for more terms than it has names for has no value.
  const ValueId beyond = graph_.constant(bound.indices.back() + 1);
  const ValueId none = add_constant(graph_, std::numeric_limits<double>::quiet_NaN(), graph_.at(total).type);
  return graph_.add(Op::Select, {graph_.add(Op::Less, {last, beyond}), total, none});
}

ValueId Lowering::integral(NodeId node) {
  const uint32_t position = position_of(node);
  const NodeId range = block_.tree.child(node, 0);
  const NodeId body = block_.tree.child(node, 1);
  if (block_.tree.node(range).kind == NodeKind::Domain) return over_directions(body, range, position);
  return between(child_value(range, 0), child_value(range, 1),
                 [&](ValueId variable) { return body_with(body, position, variable); });
}

/// As an integral from 0 to 1.
template <typename BodyAt>
ValueId Lowering::between(ValueId lower, ValueId upper, BodyAt body_at) {
  const uint32_t binder = graph_.new_binder();
  const ValueId variable = graph_.leaf(Op::BoundVariable, Type::Real, binder);
  const ValueId width = graph_.add(Op::Subtract, {upper, lower});
  const ValueId place = graph_.add(Op::Add, {lower, graph_.add(Op::Multiply, {width, variable})});
  return graph_.add(Op::Multiply, {width, graph_.add(Op::Integral, {body_at(place)}, binder)});
}

/// Over the cosine of the angle to the normal, and the azimuth.
ValueId Lowering::over_directions(NodeId body, NodeId domain, uint32_t position) {
  const bool is_sphere = directions_of(block_, domain) == Directions::Sphere;
  return between(graph_.constant(is_sphere ? -1 : 0), graph_.constant(1), [&](ValueId cosine) {
    return between(graph_.constant(0), graph_.constant(2 * kPi),
                   [&](ValueId azimuth) { return body_with(body, position, direction(cosine, azimuth)); });
  });
}

ValueId Lowering::direction(ValueId cosine, ValueId azimuth) {
  const ValueId square = graph_.add(Op::Multiply, {cosine, cosine});
  const ValueId sine = graph_.add(Op::Sqrt, {graph_.add(Op::Subtract, {graph_.constant(1), square})});
  const auto along = [&](ValueId length, Convention axis) {
    return graph_.add(Op::Multiply, {length, convention(axis)});
  };
  const ValueId x = along(graph_.add(Op::Multiply, {sine, graph_.add(Op::Cos, {azimuth})}), Convention::Tangent);
  const ValueId y = along(graph_.add(Op::Multiply, {sine, graph_.add(Op::Sin, {azimuth})}), Convention::Bitangent);
  return graph_.add(Op::Add, {graph_.add(Op::Add, {x, y}), along(cosine, Convention::Normal)});
}

ValueId Lowering::derivative(NodeId node) {
  const bool is_repeated = block_.tree.node(node).child_count > 2;
  const auto times = is_repeated ? static_cast<uint32_t>(number(block_.tree.child(node, 2))) : 1;
  return repeated_derivative(child_value(node, 1), times, [&](ValueId variable) {
    return body_with(block_.tree.child(node, 0), position_of(node), variable);
  });
}

/// `f'(x)`, `f''(x)`
ValueId Lowering::derivative_call(NodeId node) {
  const NodeId name = block_.tree.child(node, 0);
  const Node& spelling = block_.tree.node(name);
  const auto tokens = std::span(block_.tokens).subspan(spelling.first_token, spelling.end_token - spelling.first_token);
  const auto primes = std::ranges::count(tokens, TokenKind::Prime, &Token::kind);
  return repeated_derivative(child_value(node, 1), static_cast<uint32_t>(primes), [&](ValueId variable) {
    return graph_.leaf(Op::Call, type(name), referent(name).index, std::array{variable});
  });
}

/// What is taken once more is a function of the variable around it; of a name of the document, of that name.
template <typename BodyAt>
ValueId Lowering::repeated_derivative(ValueId place, uint32_t times, const BodyAt& body_at) {
  const uint32_t binder = graph_.new_binder();
  const ValueId variable = graph_.leaf(Op::BoundVariable, Type::Real, binder);
  if (times <= 1) return graph_.add(Op::Derivative, {place, body_at(variable)}, binder);
  const Op op = graph_.at(place).op;
  const bool is_of_document = op == Op::Reference || op == Op::Convention;
  const ValueId inner = repeated_derivative(is_of_document ? place : variable, times - 1, body_at);
  return graph_.add(Op::Derivative, {place, inner}, binder);
}

}  // namespace texbrdf::ir
