#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <vector>

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

  /// The same for the function with parameters of other types.
  template <typename Make>
  const ir::LinkableDefinition& linkable_as(const std::vector<Type>& parameters, const Make& make) const {
    const std::lock_guard lock(instances_mutex_);
    std::unique_ptr<const ir::LinkableDefinition>& known = instances_[parameters];
    if (!known) known = std::make_unique<const ir::LinkableDefinition>(make());
    return *known;
  }

 private:
  mutable std::once_flag linkable_once_;
  mutable std::unique_ptr<const ir::LinkableDefinition> linkable_;
  mutable std::mutex instances_mutex_;
  mutable std::map<std::vector<Type>, std::unique_ptr<const ir::LinkableDefinition>> instances_;
};

}  // namespace texbrdf
