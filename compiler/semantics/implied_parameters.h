#pragma once

#include <vector>

#include "semantics/body_view.h"

namespace texbrdf {

/// A plain definition may be made of what a function calls its parameters: beside `\Lambda(\omega) = \frac{1}{1 + a}`,
/// `a = \frac{1}{\alpha \tan\theta}` is about the angle of ω. It is checked as a function of such names, its implied
/// parameters, and whoever mentions it hands on what they mean there.

/// What functions of the same display call their parameters that mention the plain definition, directly or by others of
/// the display. Only the nearest definitions are looked at.
std::vector<NameId> parameters_of_users(const DefinitionView& view);

/// What the parameters of a definition that has them are called.
inline std::vector<NameId> names_of_parameters(const CheckedDefinition& checked) {
  std::vector<NameId> names;
  for (const CheckedParameter& parameter : checked.parameters) names.push_back(parameter.name);
  return names;
}

}  // namespace texbrdf
