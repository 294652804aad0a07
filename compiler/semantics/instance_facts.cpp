#include "semantics/instance_facts.h"

#include <algorithm>

namespace texbrdf {
namespace {

constexpr InstanceFact kTooLarge = {InstanceFact::Kind::TooLarge, Type::Error, kMaxInstanceSize + 1};

bool takes(const Signature& signature, size_t position, Type argument) {
  const bool is_colour = is_triple(argument) && is_componentwise(argument);
  return fits(argument, signature.parameters[position]) || (signature.is_spread(position) && is_colour);
}

}  // namespace

InstanceFact InstanceFacts::instance(const Instance& instance) const {
  InstancesOfFunction& known = known_instances(instance.function);
  const auto found = known.find(instance.parameters);
  if (found != known.end()) {
    note_call(instance, found->second.size);
    return found->second;
  }
  if (open_.empty()) checked_ = 0;
  if (is_given_up_ || ++checked_ > kMaxInstanceSize) {
    is_given_up_ = true;
    return kTooLarge;
  }
  InstanceFact fact = check(instance);
  const bool is_outermost = open_.empty();
  // Of those within, nobody knows whether they are too large by themselves.
  if (is_given_up_ && !is_outermost) return kTooLarge;
  if (is_given_up_ || fact.size > kMaxInstanceSize) fact = kTooLarge;
  is_given_up_ = false;
  known.emplace(instance.parameters, fact);
  note_call(instance, fact.size);
  return fact;
}

InstanceFact InstanceFacts::check(const Instance& instance) const {
  const std::optional<DefinitionView> view = definition(instance.function);
  if (!view) return {};
  open_.emplace_back();
  const CheckedDefinition checked =
      check_instance(view->block, view->syntax, view->names, view->table, *this, instance.parameters);
  const uint32_t size = open_.back().size;
  open_.pop_back();
  if (!checked.sound) return {InstanceFact::Kind::Misfit, Type::Error, size};
  return {InstanceFact::Kind::Fits, checked.signature.result, size};
}

void InstanceFacts::note_call(const Instance& instance, uint32_t size) const {
  if (open_.empty() || !open_.back().called.insert(instance).second) return;
  open_.back().size = std::min(open_.back().size + size, kTooLarge.size);
}

std::optional<Instance> called_instance(NameId function, const Signature& signature, std::span<const Type> arguments) {
  if (arguments.size() != signature.parameters.size()) return std::nullopt;
  bool is_taken = true;
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i] == Type::Error || signature.parameters[i] == Type::Error) return std::nullopt;
    if (takes(signature, i, arguments[i])) continue;
    if (!signature.is_open(i) || arguments[i] == Type::Boolean) return std::nullopt;
    is_taken = false;
  }
  if (is_taken) return std::nullopt;
  Instance instance{function, signature.parameters};
  for (size_t i = 0; i < arguments.size(); ++i) {
    if (signature.is_open(i)) instance.parameters[i] = arguments[i];
  }
  return instance;
}

}  // namespace texbrdf
