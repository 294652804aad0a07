#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <string_view>

namespace texbrdf::scene {

/// What an object of a tree is, from objects.def; `UserPrimitive` stands for all primitives of users.
enum class ObjectKind : uint8_t {
#define SCENE_OBJECT(kind, ...) kind,
#include "scene/objects.def"
#undef SCENE_OBJECT
  UserPrimitive,
};

enum class ObjectClass : uint8_t {
  Primitive,
  Primitive2d,  ///< stands below an Extrusion or a Revolution
  Domain,       ///< changes where its children are asked
  Unary,        ///< changes what its children say
  Binary,       ///< joins any number of children
};

/// What the distance function of an object says, if those of its children are exact.
enum class Exactness : uint8_t {
  Exact,         ///< the signed distance
  ExactOutside,  ///< the distance outside, at most the distance inside
  Bound,         ///< at most the distance
  Deforming,     ///< may exceed the distance by the factor that `lipschitz_bounds` tells
};

/// The values that a number may have; all are finite.
enum class Domain : uint8_t {
  Any,
  Positive,
  NotNegative,
  UpToQuarterTurn,  ///< more than 0 and less than π/2
  UpToHalfTurn,     ///< more than 0 and at most π
  Count,            ///< a whole number, 0 to kMaxCopies
  Flag,             ///< 0 or 1
};

inline constexpr std::size_t kMaxData = 8;
inline constexpr double kMaxCopies = 1'000'000;
/// Ids of primitives below are those of objects.def, or reserved.
inline constexpr uint32_t kFirstUserPrimitive = 33;

/// Defaults that are the value of another number.
inline constexpr double kSameAsFirst = std::numeric_limits<double>::infinity();
inline constexpr double kSameAsThird = -std::numeric_limits<double>::infinity();

struct Datum {
  std::string_view name;
  double default_value = 0;
  Domain domain = Domain::Any;
};

struct ObjectEntry {
  ObjectKind kind;
  ObjectClass object_class;
  uint32_t id;            ///< of a primitive; 0 for an operation
  std::string_view name;  ///< "Primitives/Sphere"
  Exactness exactness;
  std::array<Datum, kMaxData> data;
  std::size_t data_count;
  std::string_view source;

  std::span<const Datum> numbers() const { return std::span(data).first(data_count); }
};

/// All of objects.def.
std::span<const ObjectEntry> object_entries();
/// Not for UserPrimitive.
const ObjectEntry& object_entry(ObjectKind kind);
/// nullptr where there is none of that name.
const ObjectEntry* find_object(std::string_view name);
/// nullptr where there is no built-in primitive with that id.
const ObjectEntry* find_primitive(uint32_t id);

/// The numbers of an object, of which the first are given: the others have their defaults.
std::array<double, kMaxData> with_defaults(const ObjectEntry& entry, std::span<const double> given);

}  // namespace texbrdf::scene
