#include "semantics/argument_expressions.h"

#include <algorithm>

namespace texbrdf {

ArgumentExpressions::ArgumentExpressions(const DefinitionView& view, std::span<const CheckedParameter> parameters)
    : view_(view) {
  for (uint32_t i = 0; i < parameters.size(); ++i) {
    const CheckedParameter& parameter = parameters[i];
    const bool is_name = parameter.name.valid() && parameter.given == parameter.node;
    if (is_name || view.node(parameter.given).kind == NodeKind::Name) continue;
    expressions_.push_back({view.without_groups(parameter.given), i});
    if (!parameter.name.valid()) note_names(parameter.given);
  }
}

void ArgumentExpressions::note_names(NodeId expression) {
  if (view_.name(expression).valid()) names_.insert(view_.name(expression));
  for (const NodeId child : view_.block.tree.children(expression)) note_names(child);
}

void ArgumentExpressions::find(ResolvedBody& body) {
  for (uint32_t i = view_.body_begin(); i < view_.body_end(); ++i) {
    const NodeId node{i};
    if (view_.node(node).kind == NodeKind::Name || view_.node(node).kind == NodeKind::Group) continue;
    const auto found = std::ranges::find_if(
        expressions_, [&](const Expression& expression) { return is_same(node, expression.node); });
    if (found == expressions_.end()) continue;
    body.referents[view_.slot(node)] = {Referent::Kind::Parameter, found->position};
    for (const NodeId child : view_.block.tree.children(node)) operands_.push_back(view_.without_groups(child));
  }
  std::ranges::sort(operands_);
}

bool ArgumentExpressions::is_operand(NodeId name) const {
  return std::ranges::binary_search(operands_, name);
}

void ArgumentExpressions::note_use(NodeId name, const ResolvedBody& body) {
  if (!has_any() || !view_.name(name).valid() || !names_.find(view_.name(name))) return;
  if (body.referents[view_.slot(name)].kind != Referent::Kind::Parameter) uses_names_ = true;
}

/// As high as the expression of the left side, which is a few names.
bool ArgumentExpressions::is_same(NodeId a, NodeId b) const {
  a = view_.without_groups(a);
  b = view_.without_groups(b);
  const Node& first = view_.node(a);
  const Node& second = view_.node(b);
  if (first.kind != second.kind || first.child_count != second.child_count) return false;
  if (first.kind == NodeKind::Name) return view_.name(a).valid() && view_.name(a) == view_.name(b);
  if (first.child_count == 0) return view_.block.node_text(a) == view_.block.node_text(b);
  const Token& one = view_.token(first.token);
  const Token& other = view_.token(second.token);
  if (one.kind != other.kind || one.command != other.command) return false;
  const std::span<const NodeId> left = view_.block.tree.children(a);
  const std::span<const NodeId> right = view_.block.tree.children(b);
  return std::ranges::equal(left, right, [this](NodeId x, NodeId y) { return is_same(x, y); });
}

}  // namespace texbrdf
