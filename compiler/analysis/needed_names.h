#pragma once

#include <cstddef>
#include <vector>

#include "semantics/names.h"

namespace texbrdf {

/// The names that `root` needs, itself included, by NameId. `mentions_of` gives what the definition in force of a name
/// mentions; there are `names` names.
template <typename MentionsOf>
std::vector<bool> needed_names(size_t names, NameId root, const MentionsOf& mentions_of) {
  std::vector<bool> is_needed(names);
  is_needed[root.value] = true;
  std::vector<NameId> waiting = {root};
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
