#pragma once

#include <cstddef>
#include <vector>

#include "semantics/check.h"

namespace texbrdf {

/// A BRDF of something else than two vectors is given what its parameters are called (root_arguments.h): it needs these
/// names although it does not mention them.
inline std::vector<NameId> argument_names(const CheckedDefinition& root) {
  std::vector<NameId> names;
  if (has_brdf_parameters(root.signature)) return names;
  for (const CheckedParameter& parameter : root.parameters) {
    if (parameter.name.valid()) names.push_back(parameter.name);
  }
  return names;
}

/// The names that `root` and its arguments need, themselves included, by NameId. `mentions_of` gives what the
/// definition in force of a name mentions; there are `names` names.
template <typename MentionsOf>
std::vector<bool> needed_names(size_t names, NameId root, const CheckedDefinition* definition,
                               const MentionsOf& mentions_of) {
  std::vector<bool> is_needed(names);
  std::vector<NameId> waiting = {root};
  if (definition != nullptr) {
    const std::vector<NameId> arguments = argument_names(*definition);
    waiting.insert(waiting.end(), arguments.begin(), arguments.end());
  }
  for (NameId name : waiting) is_needed[name.value] = true;
  while (!waiting.empty()) {
    const NameId user = waiting.back();
    waiting.pop_back();
    for (NameId name : mentions_of(user)) {
      if (is_needed[name.value]) continue;
      is_needed[name.value] = true;
      waiting.push_back(name);
    }
  }
  return is_needed;
}

}  // namespace texbrdf
