#pragma once

#include "semantics/body_view.h"
#include "semantics/small_name_map.h"

namespace texbrdf {

/// The plain letters of a body that stand where only a number can: below a line, in a power, in a function, beside a
/// number that is added. They are found when one is first asked for.
class NumberPlaces {
 public:
  explicit NumberPlaces(const DefinitionView& view) : view_(view) {}

  /// Only of letters without decoration: a decorated name says that it is a vector.
  bool is_number(NameId name);

 private:
  void find();
  void read(NodeId id);
  void read_operation(TokenKind op, NodeId left, NodeId right);
  void read_sum(NodeId left, NodeId right);
  void add(NodeId operand);

  const DefinitionView& view_;
  SmallNameMap numbers_;
  bool is_found_ = false;
};

}  // namespace texbrdf
