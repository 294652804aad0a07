#include "semantics/direction_places.h"

#include <algorithm>

namespace texbrdf {
namespace {

bool is_called_direction(const NameTraits& traits) {
  return traits.meaning() && convention_entry(*traits.meaning()).type == Type::Vector;
}

}  // namespace

bool DirectionPlaces::is_direction(NodeId name) {
  if (!is_number_called_direction(name)) return false;
  if (!is_found_) find();
  return std::ranges::binary_search(places_, name);
}

void DirectionPlaces::find() {
  is_found_ = true;
  for (uint32_t i = view_.body_begin(); i < view_.body_end(); ++i) {
    const Node& node = view_.node(NodeId{i});
    const bool is_dot = node.kind == NodeKind::Infix && view_.block.token_text(node.token) == "\\cdot";
    if (!is_dot) continue;
    const NodeId left = view_.block.tree.child(NodeId{i}, 0);
    const NodeId right = view_.block.tree.child(NodeId{i}, 1);
    read_product(left, right);
    read_product(right, left);
  }
  std::ranges::sort(places_);
}

void DirectionPlaces::read_product(NodeId operand, NodeId other) {
  operand = view_.without_groups(operand);
  if (is_number_called_direction(operand) && is_vector(other)) places_.push_back(operand);
}

bool DirectionPlaces::is_number_called_direction(NodeId id) const {
  if (view_.node(id).kind != NodeKind::Name || !view_.name(id).valid() || is_bound(id)) return false;
  const NameId name = view_.name(id);
  const NameTraits& traits = view_.table.traits(name);
  if (view_.table.text(name).size() != 1 || !is_called_direction(traits) || is_parameter(name)) return false;
  const NameFact& fact = view_.facts.fact(name);
  return fact.kind == NameFact::Kind::Defined && !fact.signature.is_function && fact.signature.result == Type::Real;
}

/// By its names alone: types are formed later.
bool DirectionPlaces::is_vector(NodeId id) const {
  const std::span<const NodeId> children = view_.block.tree.children(id);
  const auto is_one = [this](NodeId child) { return is_vector(child); };
  switch (view_.node(id).kind) {
    case NodeKind::Name:
      return is_name_of_vector(id);
    case NodeKind::VectorLiteral:
      return true;
    case NodeKind::Group:
    case NodeKind::Prefix:
      return is_vector(children[0]);
    case NodeKind::Fraction:
      return !children.empty() && is_vector(children[0]);
    case NodeKind::Infix: {
      const TokenKind op = view_.token(view_.node(id).token).kind;
      return (op == TokenKind::Plus || op == TokenKind::Minus) && std::ranges::any_of(children, is_one);
    }
    case NodeKind::Juxtaposition:
      return std::ranges::any_of(children, is_one);
    default:
      return false;
  }
}

bool DirectionPlaces::is_name_of_vector(NodeId id) const {
  const NameId name = view_.name(id);
  if (!name.valid() || is_bound(id)) return false;
  const NameTraits& traits = view_.table.traits(name);
  if (is_parameter(name)) return traits.is_vector;
  const NameFact& fact = view_.facts.fact(name);
  if (fact.kind == NameFact::Kind::Absent) return is_called_direction(traits);
  return !fact.signature.is_function && fact.signature.result == Type::Vector;
}

bool DirectionPlaces::is_bound(NodeId id) const {
  return view_.names.bound_use(id) != nullptr;
}

bool DirectionPlaces::is_parameter(NameId name) const {
  if (view_.node(view_.syntax.left).kind != NodeKind::Signature) return false;
  const std::span<const NodeId> parameters = view_.block.tree.children(view_.syntax.left).subspan(1);
  return std::ranges::any_of(
      parameters, [&](NodeId parameter) { return view_.names.of_parameter(view_.block, parameter) == name; });
}

}  // namespace texbrdf
