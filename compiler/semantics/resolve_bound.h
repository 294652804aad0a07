#pragma once

#include "semantics/body_view.h"

namespace texbrdf {

/// What the binders of a definition bind, and what names with an index stand for, as far as the definition's text and
/// the facts say. Reports what is wrong with a binder itself.
class BoundScopes {
 public:
  BoundScopes(const DefinitionView& view, ResolvedBody& body, std::vector<Diagnostic>& diagnostics);

  void advance_to(NodeId node);
  /// Where the Name is bound.
  std::optional<Referent> bound(NodeId node) const;
  /// A name of a direction that is integrated over, or of its angle.
  std::optional<Referent> direction(NameId name) const;
  /// It is the variable of a binder that is open.
  bool binds(NameId name) const;
  std::optional<Referent> indexed(NodeId node);
  /// `f'`, where f is a function of one real.
  std::optional<Referent> derivative(NodeId node) const;
  /// Once all names are read: which sums are written out.
  void decide_terms();

 private:
  void add(const Binder& binder);
  bool take_names(const StandIn& stand_in, IndexedName& indexed);
  bool is_defined(NameId name) const;
  bool have_one_type(NodeId node, IndexedName& indexed);
  uint64_t multiplicity(uint32_t position) const;
  void report(Code code, Location where, std::vector<std::string> arguments);

  const DefinitionView& view_;
  ResolvedBody& body_;
  std::vector<Diagnostic>& diagnostics_;
  OpenBinders open_;
  uint32_t first_ = 0;  // of the definition's binders among those of the block
  bool is_too_deep_ = false;
  std::vector<bool> is_needed_;  // by bound name: names carry its index
};

}  // namespace texbrdf
