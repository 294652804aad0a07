#include "semantics/resolve_bound.h"

#include <algorithm>
#include <string>

#include "semantics/implied_angle.h"

namespace texbrdf {
namespace {

/// Sums that are written out without need, and values that all written terms may have.
constexpr size_t kFewTerms = 8;
constexpr uint64_t kMostWrittenNodes = 100'000;
/// Loops of one definition; a graph has 64 binders.
constexpr uint64_t kMostLoops = 60;

std::span<const Binder> binders_of(const DefinitionView& view) {
  const std::vector<Binder>& all = view.names.binders;
  const auto begin = std::ranges::lower_bound(all, view.syntax.left, {}, &Binder::node);
  const auto end = std::ranges::upper_bound(all, view.syntax.body, {}, &Binder::node);
  return {begin, end};
}

/// An integral is a loop over panels and one over points; one over directions is two integrals.
uint64_t loops_of(const Binder& binder, const DefinitionView& view) {
  if (binder.is_over_directions) return 4;
  return view.node(binder.node).kind == NodeKind::Integral ? 2 : 1;
}

}  // namespace

BoundScopes::BoundScopes(const DefinitionView& view, ResolvedBody& body, std::vector<Diagnostic>& diagnostics)
    : view_(view), body_(body), diagnostics_(diagnostics), open_(binders_of(view)) {
  const std::span<const Binder> binders = binders_of(view);
  if (binders.empty()) return;
  first_ = static_cast<uint32_t>(binders.data() - view.names.binders.data());
  for (const Binder& binder : binders) add(binder);
  is_needed_.resize(binders.size());
}

void BoundScopes::add(const Binder& binder) {
  BoundName bound;
  bound.node = binder.node;
  bound.variable = binder.variable;
  bound.first_node = binder.first_node;
  bound.indices = binder.indices;
  bound.is_open = binder.is_open;
  if (binder.is_over_directions) {
    bound.type = Type::Vector;
    const NameId name = view_.name(binder.variable);
    if (name.valid() && view_.table.traits(name).meaning()) bound.shadowed = {*view_.table.traits(name).meaning()};
    if (!directions_of(view_.block, binder.range)) {
      report(Code::UnknownDomain, view_.at(binder.range), {std::string(view_.block.node_text(binder.range))});
    }
  }
  body_.bound.push_back(std::move(bound));
}

void BoundScopes::advance_to(NodeId node) {
  open_.advance_to(node.value);
  if (is_too_deep_ || open_.open().size() <= kMostNestedBinders) return;
  is_too_deep_ = true;
  const Binder& binder = binders_of(view_)[open_.open()[kMostNestedBinders]];
  report(Code::BindersTooDeep, view_.at_token(view_.node(binder.node).token), {std::to_string(kMostNestedBinders)});
}

std::optional<Referent> BoundScopes::bound(NodeId node) const {
  const BoundUse* use = view_.names.bound_use(node);
  if (use == nullptr) return std::nullopt;
  return Referent{Referent::Kind::Bound, use->binder - first_};
}

std::optional<Referent> BoundScopes::direction(NameId name) const {
  const std::string_view text = view_.table.text(name);
  const std::optional<ImpliedAngle> angle = implied_angle(text);
  const std::span<const uint32_t> open = open_.open();
  for (size_t i = open.size(); i-- > 0;) {
    const BoundName& bound = body_.bound[open[i]];
    const NameId variable = view_.name(bound.variable);
    if (bound.type != Type::Vector || !variable.valid()) continue;
    const std::string_view label = direction_label(view_.table.text(variable));
    if (angle && angle->label == label) {
      return angle_referent({angle->kind, open[i]}, Referent::Kind::BoundAngle);
    }
    const bool is_direction = view_.table.traits(name).is_vector || text.starts_with("\\omega");
    if (is_direction && direction_label(text) == label) return Referent{Referent::Kind::Bound, open[i]};
  }
  return std::nullopt;
}

bool BoundScopes::binds(NameId name) const {
  return std::ranges::any_of(open_.open(), [&](uint32_t i) { return view_.name(body_.bound[i].variable) == name; });
}

bool BoundScopes::is_defined(NameId name) const {
  return view_.facts.fact(name).kind == NameFact::Kind::Defined;
}

std::optional<Referent> BoundScopes::indexed(NodeId node) {
  const StandIn* stand_in = view_.names.stand_in(node);
  if (stand_in == nullptr || stand_in->binders.empty()) return std::nullopt;
  IndexedName indexed;
  if (!take_names(*stand_in, indexed) || !have_one_type(node, indexed)) return std::nullopt;
  for (const uint32_t bound : indexed.bound) is_needed_[bound] = true;
  body_.indexed.push_back(std::move(indexed));
  return Referent{Referent::Kind::Indexed, static_cast<uint32_t>(body_.indexed.size() - 1)};
}

/// All, or as many as there are in a row where the document says how many indices there are.
bool BoundScopes::take_names(const StandIn& stand_in, IndexedName& indexed) {
  indexed.names = stand_in.names;
  size_t known = stand_in.names.size();
  for (const uint32_t binder : stand_in.binders) {
    indexed.bound.push_back(binder - first_);
    indexed.counts.push_back(view_.names.binders[binder].indices.size());
  }
  const bool is_one_open = indexed.bound.size() == 1 && body_.bound[indexed.bound[0]].is_open;
  for (size_t i = 0; i < known; ++i) {
    if (is_defined(stand_in.names[i])) continue;
    if (!is_one_open || i == 0) return false;
    known = i;
  }
  if (!is_one_open) return true;
  std::vector<int>& indices = body_.bound[indexed.bound[0]].indices;
  indices.resize(std::min(indices.size(), known));
  return true;
}

bool BoundScopes::have_one_type(NodeId node, IndexedName& indexed) {
  indexed.signature = view_.facts.fact(indexed.names[0]).signature;
  for (size_t i = 1; i < indexed.names.size(); ++i) {
    const NameFact& fact = view_.facts.fact(indexed.names[i]);
    if (fact.kind != NameFact::Kind::Defined) break;
    const Signature& other = fact.signature;
    Signature& signature = indexed.signature;
    signature.spreads &= other.spreads;
    const bool is_known = signature.result != Type::Error && other.result != Type::Error;
    const bool fits_it = signature.is_function == other.is_function && signature.parameters == other.parameters &&
                         (!is_known || fits(other.result, signature.result));
    if (!is_known) signature.result = Type::Error;
    if (signature.result == Type::Tuple) signature.result = other.result;
    if (fits_it) continue;
    report(Code::IndexedTypes, view_.at(node),
           {shown_name(view_.table.text(indexed.names[0])), shown_name(view_.table.text(indexed.names[i])),
            view_.name_text(node)});
    signature.result = Type::Error;
    signature.parameters.clear();
    return true;
  }
  return true;
}

std::optional<Referent> BoundScopes::derivative(NodeId node) const {
  const StandIn* stand_in = view_.names.stand_in(node);
  if (stand_in == nullptr || !stand_in->binders.empty()) return std::nullopt;
  if (stand_in->names[0] == view_.name(view_.syntax.name)) return std::nullopt;
  const NameFact& fact = view_.facts.fact(stand_in->names[0]);
  const auto shorter = std::span(stand_in->names).subspan(1);
  if (std::ranges::any_of(shorter, [this](NameId name) { return is_defined(name); })) return std::nullopt;
  const bool is_function_of_real = fact.kind == NameFact::Kind::Defined && fact.signature.is_function &&
                                   fact.signature.parameters == std::vector{Type::Real};
  if (!is_function_of_real) return std::nullopt;
  return Referent{Referent::Kind::Derivative, stand_in->names[0].value};
}

/// How often the binder's own node is written.
uint64_t BoundScopes::multiplicity(uint32_t position) const {
  uint64_t times = 1;
  const std::span<const Binder> binders = binders_of(view_);
  for (uint32_t outer = position + 1; outer < binders.size() && times <= kMostWrittenNodes; ++outer) {
    const bool is_inside =
        binders[outer].first_node <= binders[position].node.value && binders[position].node <= binders[outer].body;
    const BoundName& bound = body_.bound[outer];
    if (is_inside && bound.is_written_out) times *= std::max<size_t>(bound.indices.size(), 1);
  }
  return times;
}

void BoundScopes::decide_terms() {
  const std::span<const Binder> binders = binders_of(view_);
  uint64_t nodes = 0;
  uint64_t loops = 0;
  constexpr size_t kMostBinders = 1000;
  for (auto position = static_cast<uint32_t>(binders.size()); position-- > 0;) {
    const Binder& binder = binders[position];
    BoundName& bound = body_.bound[position];
    const bool is_sum = view_.node(binder.node).kind == NodeKind::BigOperator;
    const bool is_set = is_sum && view_.node(binder.range).kind == NodeKind::Set;
    const uint64_t times = binders.size() > kMostBinders ? kMostWrittenNodes : multiplicity(position);
    const size_t terms = is_set ? view_.node(binder.range).child_count : bound.indices.size();
    const uint64_t written = times * terms * (binder.body.value + 1 - binder.first_node);
    const bool is_short = !bound.is_open && terms > 0 && terms <= kFewTerms && nodes + written < kMostWrittenNodes / 10;
    bound.is_written_out = is_set || is_needed_[position] || is_short;
    if (bound.is_written_out) nodes += written;
    if (!bound.is_written_out) loops += times * loops_of(binder, view_);
    if (nodes <= kMostWrittenNodes && loops <= kMostLoops) continue;
    const uint32_t command = view_.node(binder.node).token;
    report(Code::TooManyTerms, view_.at_token(command), {std::string(view_.block.token_text(command))});
    return;
  }
}

void BoundScopes::report(Code code, Location where, std::vector<std::string> arguments) {
  diagnostics_.push_back(make_diagnostic(code, where, std::move(arguments)));
}

}  // namespace texbrdf
