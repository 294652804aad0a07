#pragma once

#include <optional>
#include <string>

#include "analysis/snapshot.h"
#include "features/text_edit.h"

namespace texbrdf::features {

struct NewDefinition {
  std::string title;
  TextEdit edit;
};

/// A new equation, written as the one where the name is missing, that defines it with a value to be replaced: a
/// function where it is called, a vector where only a vector fits. Nothing for other problems.
std::optional<NewDefinition> define_missing_name(const Snapshot& snapshot, const Diagnostic& diagnostic);

}  // namespace texbrdf::features
