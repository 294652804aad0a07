#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "ir/graph.h"
#include "ir/lower.h"
#include "ir/matrix_algebra.h"
#include "semantics/builtin_functions.h"
#include "syntax/matrix_power.h"

namespace texbrdf::ir {

/// Lowers the nodes of one definition bottom-up; every lowered node has one value. For lower*.cpp only.
class Lowering {
 public:
  Lowering(const ParsedBlock& block, const DefinitionSyntax& definition, const CheckedDefinition& checked,
           Expressions expressions);

  Graph run();

 private:
  std::size_t slot(NodeId node) const { return node.value - definition_.first_node; }
  ValueId value(NodeId node) const { return values_[slot(node)]; }
  ValueId child_value(NodeId node, uint32_t index) const { return value(block_.tree.child(node, index)); }
  Type type(NodeId node) const { return checked_.types[slot(node)]; }
  const Referent& referent(NodeId node) const { return checked_.referents[slot(node)]; }
  const Token& token(NodeId node) const { return block_.tokens[block_.tree.node(node).token]; }

  // The walk (lower.cpp).
  ValueId lower_tree(NodeId root, uint32_t first);
  void mark_needed(NodeId root, uint32_t first);
  std::span<const NodeId> lowered_before(NodeId node) const;
  bool is_argument(NodeId node) const;
  ValueId lower(NodeId node);
  double number(NodeId node) const;

  // Names and what the convention makes of them (lower_names.cpp).
  ValueId name(NodeId node);
  ValueId value_of(const TypedReferent& meaning);
  ValueId derived(const DerivedNumber& number);
  ValueId parameter(uint32_t position);
  ValueId formal(uint32_t position);
  ValueId angle(Convention kind, ValueId direction);
  NameId name_at(const IndexedName& indexed) const;
  ValueId convention(Convention id);
  std::optional<uint32_t> shadowing_parameter(Convention id) const;

  // Operators and elementary functions (lower_operators.cpp).
  ValueId infix(NodeId node);
  bool is_euler(ValueId id) const;
  ValueId product(NodeId node, ValueId left, ValueId right);
  bool is_cross_product(ValueId left, ValueId right) const;
  ValueId bars(NodeId node);
  ValueId angles(NodeId node);
  ValueId root(NodeId node);
  ValueId function(NodeId node);
  ValueId extremum(NodeId node);

  // Matrices and vectors of two and four (lower_matrices.cpp).
  MatrixValue matrix_of(ValueId id, Type type);
  ValueId value_of_matrix(const MatrixValue& matrix, Type type);
  ValueId entry(ValueId aggregate, uint32_t index);
  ValueId matrix(NodeId node);
  MatrixPower matrix_power_of(NodeId node) const;
  ValueId power_of_matrix(NodeId node, MatrixPower power);
  bool is_of_matrices(NodeId node) const;
  ValueId matrix_operation(NodeId node, Op op);
  ValueId matrix_product(NodeId node);
  std::optional<NodeId> transposed_vector(NodeId node) const;
  ValueId negated_matrix(NodeId node);
  ValueId length_of_matrix(const MatrixValue& matrix);
  ValueId choice_of_matrices(ValueId condition, ValueId then, ValueId otherwise, Type type);
  ValueId matrix_builtin(NodeId node, Builtin function);

  // Sums, integrals and derivatives (lower_binders.cpp).
  uint32_t position_of(NodeId binder) const;
  ValueId body_with(NodeId body, uint32_t position, ValueId bound);
  void follow(std::span<const Convention> shadowed, ValueId bound);
  ValueId sum(NodeId node);
  bool is_product(NodeId node) const;
  ValueId written_sum(NodeId node, uint32_t position);
  ValueId integral(NodeId node);
  template <typename BodyAt>
  ValueId between(ValueId lower, ValueId upper, BodyAt body_at);
  ValueId over_directions(NodeId body, NodeId domain, uint32_t position);
  ValueId direction(ValueId cosine, ValueId azimuth);
  ValueId derivative(NodeId node);
  ValueId derivative_call(NodeId node);
  template <typename BodyAt>
  ValueId repeated_derivative(ValueId place, uint32_t times, const BodyAt& body_at);

  // Cases and their conditions (lower_conditions.cpp).
  ValueId cases(NodeId node);
  bool has_condition(NodeId row) const;
  ValueId comparison(NodeId node);
  ValueId relation(NodeId node, uint32_t index);
  ValueId membership(NodeId node);

  // Calls (lower_calls.cpp).
  ValueId builtin(NodeId node, Builtin function);
  ValueId call(NodeId node);
  std::optional<uint32_t> instance_index(NodeId callee) const;
  ValueId implied_call(const ImpliedCall& call);
  ValueId call_of(uint32_t callee, Type result, std::span<const ValueId> arguments, uint64_t spread);
  std::vector<ValueId> with_entries(std::span<const ValueId> arguments);
  bool is_spread(NodeId argument) const;

  const ParsedBlock& block_;
  const DefinitionSyntax& definition_;
  const CheckedDefinition& checked_;
  const Expressions expressions_;
  Graph graph_;
  std::vector<uint32_t>
      formals_;  ///< by parameter, the position of the first formal: each entry of an aggregate has one
  std::vector<ValueId> values_;
  std::vector<bool> needed_;
  std::vector<ValueId> bound_;             ///< by position, of the binders that are open
  std::map<uint32_t, std::size_t> terms_;  ///< by position, of sums that are being written out
  std::vector<ValueId> conventions_ = std::vector<ValueId>(conventions().size());
};

}  // namespace texbrdf::ir
