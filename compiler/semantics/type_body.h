#pragma once

#include <span>
#include <vector>

#include "semantics/body_view.h"

namespace texbrdf {

/// What a call may be of.
enum class Calls : uint8_t {
  AsDefined,       ///< the function as it reads by itself
  MayBeInstances,  ///< that, or else an Instance for the arguments' types
};

/// Types of a body under one reading of its parameters, by slot (the left side stays Error), and what is wrong.
/// Where an operand has no known type the result has one if the rules fix it all the same; but nothing is reported that
/// has to do with such an operand, however far below.
struct TypedBody {
  std::vector<Type> types;
  std::vector<Diagnostic> diagnostics;
  std::vector<NodeId> spread_arguments;      ///< as in CheckedDefinition
  std::vector<InstanceCall> instance_calls;  ///< as in CheckedDefinition
  bool holds_unknown = false;                ///< the body, an operand or an argument has no known type
};

/// `leaves`: body.leaves, which may be given away where it is not needed again.
TypedBody type_body(const DefinitionView& view, const ResolvedBody& body, std::vector<Type> leaves,
                    std::span<const Type> parameters, Calls calls);

}  // namespace texbrdf
