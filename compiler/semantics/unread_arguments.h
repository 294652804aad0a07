#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "semantics/body_view.h"

namespace texbrdf {

/// Names that a body hands to a parameter that nothing reads (Signature::unread), as the `x` of a BRDF that does not
/// depend on the place. Looked for when first asked.
class UnreadArguments {
 public:
  explicit UnreadArguments(const DefinitionView& view) : view_(view) {}

  /// What the parameter is, where the Name node is such an argument.
  std::optional<Type> type_of(NodeId name);

 private:
  void find();

  const DefinitionView& view_;
  bool is_found_ = false;
  std::vector<std::pair<NodeId, Type>> found_;  // in order
};

/// The parameters on which the body's value does not depend, by position, one bit each.
uint64_t unread_parameters(const DefinitionView& view, const CheckedDefinition& checked,
                           const std::vector<Referent>& referents);

}  // namespace texbrdf
