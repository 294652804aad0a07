#pragma once

#include <map>
#include <optional>
#include <set>

#include "semantics/body_view.h"

namespace texbrdf {

/// The most bodies that are checked for one call: functions hand their parameters on to others, which may double at
/// each level.
inline constexpr uint32_t kMaxInstanceSize = 100;

/// The answers for one function, by the types of its parameters.
using InstancesOfFunction = std::map<std::vector<Type>, InstanceFact>;

/// Finds out about instances by checking them, each once. What is said of one depends on the definitions alone, not on
/// what was asked before.
class InstanceFacts : public Facts {
 public:
  InstanceFact instance(const Instance& instance) const final;

 protected:
  /// The definition in force; nothing where there is none that can be called.
  virtual std::optional<DefinitionView> definition(NameId function) const = 0;
  /// What is known of the function by now.
  virtual InstancesOfFunction& known_instances(NameId function) const = 0;

 private:
  /// An instance that is being checked.
  struct Open {
    uint32_t size = 1;
    std::set<Instance> called;
  };

  InstanceFact check(const Instance& instance) const;
  void note_call(const Instance& instance, uint32_t size) const;

  mutable std::vector<Open> open_;
  mutable uint32_t checked_ = 0;      ///< for the outermost one that is open
  mutable bool is_given_up_ = false;  ///< that one is too large
};

/// The instance that a call with arguments of these types is of; nothing where the function takes them by itself, and
/// where it cannot be called with them.
std::optional<Instance> called_instance(NameId function, const Signature& signature, std::span<const Type> arguments);

}  // namespace texbrdf
