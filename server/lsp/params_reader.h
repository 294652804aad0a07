#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "lsp/protocol.h"

namespace texbrdf::lsp {

/// Reads members of a message's parameters and remembers the first that is missing or of the wrong kind. Members of
/// nothing read as defaults, so that callers need no checks in between.
class ParamsReader {
 public:
  using json = nlohmann::json;

  const std::string& problem() const { return problem_; }

  json* object(json* parent, const char* name) {
    return required(parent, name, "an object", [](const json& v) { return v.is_object(); });
  }
  json* array(json* parent, const char* name) {
    return required(parent, name, "an array", [](const json& v) { return v.is_array(); });
  }
  std::string string(json* parent, const char* name) {
    json* value = required(parent, name, "a string", [](const json& v) { return v.is_string(); });
    return value == nullptr ? std::string{} : std::move(value->get_ref<std::string&>());
  }
  bool boolean(json* parent, const char* name) {
    const json* value = required(parent, name, "a boolean", [](const json& v) { return v.is_boolean(); });
    return value != nullptr && value->get<bool>();
  }
  int64_t integer(json* parent, const char* name) {
    const json* value = required(parent, name, "an integer", is_integral);
    return value == nullptr ? 0 : integer_of(*value);
  }
  uint32_t natural(json* parent, const char* name) {
    const json* value =
        required(parent, name, "a natural number", [](const json& v) { return is_integral(v) && integer_of(v) >= 0; });
    return value == nullptr ? 0 : static_cast<uint32_t>(integer_of(*value));
  }
  /// Nothing where it is absent or null.
  std::optional<double> number(json* parent, const char* name) {
    const json* value = optional(parent, name);
    if (value == nullptr) return std::nullopt;
    if (value->is_number()) return value->get<double>();
    fail(fmt::format("`{}` has to be a number", name));
    return std::nullopt;
  }
  Position position(json* parent, const char* name) {
    json* value = object(parent, name);
    return {natural(value, "line"), natural(value, "character")};
  }
  Range range(json* value) { return {position(value, "start"), position(value, "end")}; }

  /// `params` itself, which has to be an object.
  json* object_of(json& params) {
    if (params.is_object()) return &params;
    fail("`params` has to be an object");
    return nullptr;
  }
  std::string document_uri(json* params) { return string(object(params, "textDocument"), "uri"); }

  /// The member, or nullptr where it is absent or null.
  static json* optional(json* parent, const char* name) {
    if (parent == nullptr || !parent->is_object()) return nullptr;
    const auto found = parent->find(name);
    return found == parent->end() || found->is_null() ? nullptr : &*found;
  }

  // What may be absent, or odd, without being a fault.
  static bool flag(json* parent, const char* name) {
    const json* value = optional(parent, name);
    return value != nullptr && value->is_boolean() && value->get<bool>();
  }
  static std::string text_or_empty(json* parent, const char* name) {
    const json* value = optional(parent, name);
    return value != nullptr && value->is_string() ? value->get<std::string>() : std::string{};
  }
  static std::vector<std::string> strings(const json* array) {
    std::vector<std::string> result;
    if (array == nullptr || !array->is_array()) return result;
    for (const json& element : *array) {
      if (element.is_string()) result.push_back(element.get<std::string>());
    }
    return result;
  }

  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

 private:
  /// The protocol's integers are 32 bits wide; what is beyond is read as the largest.
  static constexpr int64_t kMaxInteger = INT32_MAX;

  template <typename Predicate>
  json* required(json* parent, const char* name, const char* kind, Predicate fits) {
    if (parent == nullptr) return nullptr;
    json* value = optional(parent, name);
    if (value != nullptr && fits(*value)) return value;
    fail(fmt::format("`{}` has to be {}", name, kind));
    return nullptr;
  }
  /// Also 3.0, which some JSON libraries make of 3.
  static bool is_integral(const json& value) {
    if (!value.is_number_float()) return value.is_number_integer();
    const double number = value.get<double>();
    return number >= INT32_MIN && number <= INT32_MAX && number == static_cast<double>(static_cast<int64_t>(number));
  }
  static int64_t integer_of(const json& value) {
    if (value.is_number_unsigned()) {
      return static_cast<int64_t>(std::min<uint64_t>(value.get<uint64_t>(), kMaxInteger));
    }
    return std::clamp<int64_t>(value.get<int64_t>(), -kMaxInteger, kMaxInteger);
  }

  std::string problem_;
};

}  // namespace texbrdf::lsp
