#include "scene/primitives.h"

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "source/internal_error.h"

namespace texbrdf::scene {
namespace in_double {

using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using namespace glm;  // NOLINT(google-build-using-namespace): the functions of GLSL

#define HELPER(name, ...) inline __VA_ARGS__
#define DISTANCE_FUNCTION(kind, name, ...) inline __VA_ARGS__
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER

}  // namespace in_double

namespace {

using Data = std::array<double, kMaxData>;

template <typename... Numbers, std::size_t... Index>
double call(double (*function)(glm::dvec3, Numbers...), const glm::dvec3& place, const Data& data,
            std::index_sequence<Index...> /*indices*/) {
  return function(place, data[Index]...);
}

template <typename... Numbers>
double call(double (*function)(glm::dvec3, Numbers...), const glm::dvec3& place, const Data& data) {
  return call(function, place, data, std::index_sequence_for<Numbers...>{});
}

template <typename... Numbers>
constexpr std::size_t count_numbers(double (*)(glm::dvec3, Numbers...)) {
  return sizeof...(Numbers);
}

struct PrimitiveEntry {
  ObjectKind kind;
  PrimitiveFunction function;
  double (*evaluate)(const glm::dvec3& place, const Data& data);
};

constexpr std::array kPrimitives{
#define HELPER(name, ...)
#define DISTANCE_FUNCTION(kind, name, ...)                \
  PrimitiveEntry{ObjectKind::kind,                        \
                 {#name, count_numbers(in_double::name)}, \
                 [](const glm::dvec3& place, const Data& data) { return call(in_double::name, place, data); }},
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
};

const PrimitiveEntry& primitive_entry(ObjectKind kind) {
  const auto* const found = std::ranges::find(kPrimitives, kind, &PrimitiveEntry::kind);
  require(found != kPrimitives.end(), "there is no built-in primitive of that kind");
  return *found;
}

/// A function of the table as GLSL.
struct FunctionText {
  std::string_view name;
  std::string_view text;
};

constexpr std::array kTexts{
#define HELPER(name, ...) FunctionText{#name, #__VA_ARGS__},
#define DISTANCE_FUNCTION(kind, name, ...) FunctionText{#name, #__VA_ARGS__},
#include "scene/distance_functions.def"
#undef DISTANCE_FUNCTION
#undef HELPER
};

bool is_word(char c) {
  return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool calls(std::string_view code, std::string_view name) {
  for (std::size_t at = code.find(name); at != std::string_view::npos; at = code.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_word(code[at - 1])) && end < code.size() && code[end] == '(') return true;
  }
  return false;
}

}  // namespace

double primitive_distance(ObjectKind kind, const glm::dvec3& place, const Data& data) {
  return primitive_entry(kind).evaluate(place, data);
}

PrimitiveFunction primitive_function(ObjectKind kind) {
  return primitive_entry(kind).function;
}

double length_above(const glm::dvec2& d) {
  return in_double::length_above(d);
}

double smooth_union(double a, double b, double k) {
  return in_double::smooth_union(a, b, k);
}

double smooth_intersection(double a, double b, double k) {
  return in_double::smooth_intersection(a, b, k);
}

glm::dvec3 inverse_spacing(const Repetition& plan) {
  glm::dvec3 inverse(0);
  for (int axis = 0; axis < 3; ++axis) {
    if (plan.spacing[axis] > 0) inverse[axis] = 1 / plan.spacing[axis];
  }
  return inverse;
}

glm::dvec3 first_copy(const Repetition& plan, const glm::dvec3& x) {
  return in_double::first_copy(x, inverse_spacing(plan), plan.last, plan.window);
}

double distance_beside(const Repetition& plan, const glm::dvec3& x, const glm::dvec3& first) {
  return in_double::distance_beside(x, first, plan.spacing, inverse_spacing(plan), plan.last, plan.window, plan.half);
}

double guarded(double value, double outside, const Guard& guard) {
  return in_double::guarded(value, outside, guard.level, guard.margin);
}

double twisted_distance(double raw, double k, double radius) {
  return in_double::twisted_distance(raw, k, radius);
}

double bent_distance(double raw, double k, double radius) {
  return in_double::bent_distance(raw, k, radius);
}

double box_distance(const glm::dvec3& place, const glm::dvec3& half_size) {
  return in_double::box_distance(place, half_size);
}

glm::dvec2 turned(const glm::dvec2& place, double angle) {
  return in_double::turned(place, angle);
}

double displacement(const glm::dvec3& place, double amplitude, double frequency) {
  return in_double::displacement(place, amplitude, frequency);
}

std::string functions_for(std::string_view code) {
  std::array<bool, kTexts.size()> needed{};
  for (std::size_t i = kTexts.size(); i-- > 0;) {
    needed[i] = calls(code, kTexts[i].name);
    for (std::size_t user = i + 1; user < kTexts.size() && !needed[i]; ++user) {
      needed[i] = needed[user] && calls(kTexts[user].text, kTexts[i].name);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < kTexts.size(); ++i) {
    if (!needed[i]) continue;
    text += kTexts[i].text;
    text += '\n';
  }
  return text;
}

}  // namespace texbrdf::scene
