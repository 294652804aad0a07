#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "semantics/names.h"
#include "semantics/small_name_map.h"

namespace texbrdf {

/// What a document makes of a name: a name of the convention without a definition is Absent.
enum class NameKind : uint8_t { Absent, Value, Function };

/// What the left sides of a document say of its names.
class KnownNames {
 public:
  virtual ~KnownNames() = default;
  virtual NameKind kind(NameId name) const = 0;
  /// Of a function, as its definition calls them; one that is no name is invalid.
  virtual std::span<const NameId> parameters(NameId function) const = 0;
};

/// What the parameters of a definition are called by a call: an argument for `\cos\theta` has no name. None where it
/// has no parameters.
std::vector<NameId> parameter_names(const ParsedBlock& block, const DefinitionSyntax& definition,
                                    const BlockNames& names);
/// The names that mean parameters in the body.
SmallNameMap hidden_names(const ParsedBlock& block, const DefinitionSyntax& definition, const BlockNames& names);

}  // namespace texbrdf
