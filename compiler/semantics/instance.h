#pragma once

#include <vector>

#include "semantics/names.h"
#include "semantics/types.h"

namespace texbrdf {

/// A function as it is called: with parameters of exactly these types. Without any it is the definition as it reads by
/// itself.
struct Instance {
  NameId function;
  std::vector<Type> parameters;
  friend auto operator<=>(const Instance&, const Instance&) = default;
};

}  // namespace texbrdf
