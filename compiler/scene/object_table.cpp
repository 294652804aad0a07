#include "scene/object_table.h"

#include <algorithm>

#include "source/internal_error.h"

namespace texbrdf::scene {
namespace {

constexpr ObjectEntry entry(ObjectKind kind, ObjectClass object_class, uint32_t id, std::string_view name,
                            Exactness exactness, std::initializer_list<Datum> data, std::string_view source) {
  ObjectEntry result{kind, object_class, id, name, exactness, {}, data.size(), source};
  std::copy(data.begin(), data.end(), result.data.begin());
  return result;
}

// clang-format off
#define NUMBER(name, value, domain) Datum{name, value, Domain::domain}
#define DATA(...) std::initializer_list<Datum>{__VA_ARGS__}
#define SCENE_OBJECT(kind, object_class, id, name, exactness, data, source) \
  entry(ObjectKind::kind, ObjectClass::object_class, id, name, Exactness::exactness, data, source),
// clang-format on

constexpr std::array kEntries{
#include "scene/objects.def"
};

#undef SCENE_OBJECT
#undef DATA
#undef NUMBER

}  // namespace

std::span<const ObjectEntry> object_entries() {
  return kEntries;
}

const ObjectEntry& object_entry(ObjectKind kind) {
  require(kind != ObjectKind::UserPrimitive, "object_entry of a user primitive");
  return kEntries[static_cast<std::size_t>(kind)];
}

const ObjectEntry* find_object(std::string_view name) {
  const auto* const found =
      std::find_if(kEntries.begin(), kEntries.end(), [name](const ObjectEntry& each) { return each.name == name; });
  return found == kEntries.end() ? nullptr : found;
}

const ObjectEntry* find_primitive(uint32_t id) {
  const auto* const found = std::find_if(kEntries.begin(), kEntries.end(),
                                         [id](const ObjectEntry& each) { return id != 0 && each.id == id; });
  return found == kEntries.end() ? nullptr : found;
}

std::array<double, kMaxData> with_defaults(const ObjectEntry& entry, std::span<const double> given) {
  std::array<double, kMaxData> values{};
  for (std::size_t i = 0; i < entry.data_count; ++i) {
    const double fallback = entry.data[i].default_value;
    if (i < given.size()) {
      values[i] = given[i];
    } else if (fallback == kSameAsFirst) {
      values[i] = values[0];
    } else if (fallback == kSameAsThird) {
      values[i] = values[2];
    } else {
      values[i] = fallback;
    }
  }
  return values;
}

}  // namespace texbrdf::scene
