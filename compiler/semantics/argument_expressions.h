#pragma once

#include <span>
#include <vector>

#include "semantics/body_view.h"
#include "semantics/small_name_map.h"

namespace texbrdf {

/// Parameters that are written as an expression, as in `F(\mathbf v \cdot \mathbf h) = …` or `p(\cos\theta) = …`. Where
/// the body says the same expression it is the argument; any other use of the names in it means what it means
/// elsewhere.
class ArgumentExpressions {
 public:
  ArgumentExpressions(const DefinitionView& view, std::span<const CheckedParameter> parameters);

  bool has_any() const { return !expressions_.empty(); }
  /// Refers the nodes of the body that say such an expression to the parameter.
  void find(ResolvedBody& body);
  /// The name is an operand of such a node, so that it does not matter what it means.
  bool is_operand(NodeId name) const;
  /// A name that stands elsewhere, once it is known what it refers to.
  void note_use(NodeId name, const ResolvedBody& body);
  bool are_all_that_is_used() const { return !uses_names_; }

 private:
  struct Expression {
    NodeId node;
    uint32_t position;
  };

  void note_names(NodeId expression);
  bool is_same(NodeId a, NodeId b) const;

  const DefinitionView& view_;
  std::vector<Expression> expressions_;
  SmallNameMap names_;            ///< in expressions that give none of them a value
  std::vector<NodeId> operands_;  ///< of the nodes that were found, in order
  bool uses_names_ = false;
};

}  // namespace texbrdf
