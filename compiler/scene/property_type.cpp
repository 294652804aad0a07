#include <algorithm>
#include <array>

#include "scene/scene.h"

namespace texbrdf::scene {
namespace {

struct TypeEntry {
  std::string_view name;
  std::size_t components;
  bool is_integer;
};

// In the order of PropertyType.
constexpr std::array kTypes{TypeEntry{"int", 1, true},    TypeEntry{"int2", 2, true},    TypeEntry{"int3", 3, true},
                            TypeEntry{"float", 1, false}, TypeEntry{"float2", 2, false}, TypeEntry{"float3", 3, false}};

const TypeEntry& entry(PropertyType type) {
  return kTypes[static_cast<std::size_t>(type)];
}

}  // namespace

std::string_view property_type_name(PropertyType type) {
  return entry(type).name;
}

std::optional<PropertyType> find_property_type(std::string_view name) {
  const auto* const found = std::ranges::find(kTypes, name, &TypeEntry::name);
  if (found == kTypes.end()) return std::nullopt;
  return static_cast<PropertyType>(found - kTypes.begin());
}

std::vector<std::string_view> property_type_names() {
  std::vector<std::string_view> names;
  for (const TypeEntry& type : kTypes) names.push_back(type.name);
  return names;
}

std::size_t component_count(PropertyType type) {
  return entry(type).components;
}

bool is_integer(PropertyType type) {
  return entry(type).is_integer;
}

}  // namespace texbrdf::scene
