#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "semantics/names.h"

namespace texbrdf {

struct EngineState;

/// The names whose value changes with a direction or an angle of the convention. Immutable, and cheap to copy.
class DirectionalNames {
 public:
  DirectionalNames() = default;
  explicit DirectionalNames(std::vector<bool> by_name)
      : by_name_(std::make_shared<const std::vector<bool>>(std::move(by_name))) {}

  /// Names that came later mean what the convention says.
  bool contains(NameId name, const NameTable& table) const {
    const bool is_listed = by_name_ && name.value < by_name_->size();
    return is_listed ? (*by_name_)[name.value] : table.traits(name).is_directional();
  }

 private:
  std::shared_ptr<const std::vector<bool>> by_name_;
};

/// Brings `state.directional` up to date after the definitions of the names `changed` have come to mention others, or
/// have come into a knot or out of one. Those in knots count as constant.
void update_directional(EngineState& state, const std::vector<NameId>& changed);

}  // namespace texbrdf
