#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "analysis/snapshot.h"
#include "features/expression.h"

namespace texbrdf::features {

enum class Markup : uint8_t { Markdown, PlainText };

/// What people are told of a name, in hovers and beside completions.

/// Name, type, equation, value where it is constant, and where it stands.
std::string describe_definition(const Snapshot& snapshot, DefinitionId id, Markup markup);
/// The same for a function that is called with other types than it takes by itself.
std::string describe_instance(const Snapshot& snapshot, DefinitionId id, const InstanceCall& call, Markup markup);
/// A parameter of the function, by its position.
std::string describe_parameter(const Snapshot& snapshot, DefinitionId id, uint32_t index, Markup markup);
/// Type and text of a part of a right side.
std::string describe_expression(const Snapshot& snapshot, const Expression& expression, Markup markup);
/// Formula and meaning. `inside` is the definition in which it stands, whose parameters it may follow; or none.
std::string describe_convention(const Snapshot& snapshot, std::string_view name, Convention convention,
                                DefinitionId inside, Markup markup);
/// The definition of a macro, and what its use stands for.
std::string describe_macro(const Snapshot& snapshot, const MacroOccurrence& macro, Markup markup);
/// An angle that is named after a parameter of `inside`.
std::string describe_angle(const Snapshot& snapshot, std::string_view name, ParameterAngle angle, DefinitionId inside,
                           Markup markup);
/// The variable of a sum, product, integral or derivative, or an angle that is named after one.
std::string describe_bound(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup);
/// A component or an angle of a vector, which the name says.
std::string describe_derived(const Snapshot& snapshot, const Occurrence& occurrence, Markup markup);
/// A function that the document need not define.
std::string describe_builtin(std::string_view name, Builtin function, Markup markup);

}  // namespace texbrdf::features
