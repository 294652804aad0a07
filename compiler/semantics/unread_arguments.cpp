#include "semantics/unread_arguments.h"

#include <algorithm>

namespace texbrdf {
namespace {

/// What is called: `a_k(x)` below a sum leaves unread what all of `a_1`, `a_2` … do.
Signature called_signature(const DefinitionView& view, NodeId callee) {
  Signature signature = view.facts.fact(view.name(callee)).signature;
  const StandIn* const stand_in = view.names.stand_in(callee);
  if (signature.is_function || stand_in == nullptr || stand_in->binders.empty()) return signature;
  signature = view.facts.fact(stand_in->names[0]).signature;
  for (const NameId name : stand_in->names) {
    const NameFact& fact = view.facts.fact(name);
    if (fact.kind == NameFact::Kind::Defined) signature.unread &= fact.signature.unread;
  }
  return signature;
}

/// Calls `visit` for each argument of the body that is one name, handed to a parameter that nothing reads.
template <typename Visit>
void visit_unread(const DefinitionView& view, const Visit& visit) {
  const SmallNameMap mentioned = mentioned_names(view.block, view.syntax, view.names);
  for (uint32_t node = view.body_begin(); node < view.body_end(); ++node) {
    if (view.node(NodeId{node}).kind != NodeKind::Apply) continue;
    const std::span<const NodeId> children = view.block.tree.children(NodeId{node});
    const NameId callee = view.name(children[0]);
    if (!callee.valid() || !mentioned.find(callee)) continue;  // else it is a parameter
    const Signature signature = called_signature(view, children[0]);
    if (signature.unread == 0 || signature.parameters.size() + 1 != children.size()) continue;
    for (size_t i = 0; i < signature.parameters.size(); ++i) {
      const NodeId argument = view.without_groups(children[i + 1]);
      const bool is_name = view.node(argument).kind == NodeKind::Name;
      if (is_name && signature.is_unread(i)) visit(argument, signature.parameters[i]);
    }
  }
}

}  // namespace

std::optional<Type> UnreadArguments::type_of(NodeId name) {
  if (!is_found_) find();
  const auto found = std::ranges::lower_bound(found_, name, {}, &std::pair<NodeId, Type>::first);
  if (found == found_.end() || found->first != name) return std::nullopt;
  return found->second;
}

void UnreadArguments::find() {
  is_found_ = true;
  visit_unread(view_, [this](NodeId argument, Type type) { found_.emplace_back(argument, type); });
  std::ranges::sort(found_);
}

uint64_t unread_parameters(const DefinitionView& view, const CheckedDefinition& checked,
                           const std::vector<Referent>& referents) {
  const size_t count = std::min<size_t>(checked.parameters.size(), 64);
  if (count == 0) return 0;
  std::vector<NodeId> handed_on;
  visit_unread(view, [&](NodeId argument, Type) { handed_on.push_back(argument); });
  std::ranges::sort(handed_on);
  uint64_t unread = count == 64 ? UINT64_MAX : (uint64_t{1} << count) - 1;
  const auto read = [&](size_t position) {
    if (position < 64) unread &= ~(uint64_t{1} << position);
  };
  for (uint32_t node = view.body_begin(); node < view.body_end(); ++node) {
    const Referent& referent = referents[view.slot(NodeId{node})];
    if (referent.kind == Referent::Kind::None || std::ranges::binary_search(handed_on, NodeId{node})) continue;
    if (referent.kind == Referent::Kind::Parameter) read(referent.index);
    if (referent.kind == Referent::Kind::Angle) read(angle_of_parameter(referent).position);
    if (referent.kind != Referent::Kind::Convention) continue;
    for (size_t i = 0; i < count; ++i) {
      if (depends_on(static_cast<Convention>(referent.index), checked.parameters[i].shadowed)) read(i);
    }
  }
  return unread;
}

}  // namespace texbrdf
