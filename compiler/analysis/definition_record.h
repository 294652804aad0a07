#pragma once

#include <memory>
#include <mutex>

#include "ir/program.h"
#include "semantics/check.h"

namespace texbrdf {

/// A checked definition and what is formed from it when it is first asked for. Kept across edits as long as its block
/// and the facts that it asked stay.
class DefinitionRecord {
 public:
  explicit DefinitionRecord(CheckedDefinition definition) : checked(std::move(definition)) {}

  const CheckedDefinition checked;

  /// Forms it with `make` at the first call. Safe from several threads.
  template <typename Make>
  const ir::LinkableDefinition& linkable(const Make& make) const {
    std::call_once(linkable_once_, [&] { linkable_ = std::make_unique<const ir::LinkableDefinition>(make()); });
    return *linkable_;
  }

 private:
  mutable std::once_flag linkable_once_;
  mutable std::unique_ptr<const ir::LinkableDefinition> linkable_;
};

}  // namespace texbrdf
