#pragma once

#include <vector>

#include "semantics/body_view.h"

namespace texbrdf {

/// Where the place of a letter that the document defines as a number says that it is the direction which papers call
/// so: the first n of `(n \cdot h)^n`. They are found when one is first asked for.
class DirectionPlaces {
 public:
  explicit DirectionPlaces(const DefinitionView& view) : view_(view) {}

  bool is_direction(NodeId name);

 private:
  void find();
  void read_product(NodeId operand, NodeId other);
  bool is_number_called_direction(NodeId id) const;
  bool is_vector(NodeId id) const;
  bool is_name_of_vector(NodeId id) const;
  bool is_bound(NodeId id) const;
  bool is_parameter(NameId name) const;

  const DefinitionView& view_;
  std::vector<NodeId> places_;  // in order
  bool is_found_ = false;
};

}  // namespace texbrdf
