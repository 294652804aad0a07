#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "source/span.h"

namespace texbrdf::scene_json {

enum class JsonKind : uint8_t { Null, Boolean, Number, String, Array, Object };

/// "a number", "an object", …
std::string_view described(JsonKind kind);

/// A value of a JsonTree; the root is 0.
struct JsonId {
  uint32_t value = 0;
  friend constexpr auto operator<=>(const JsonId&, const JsonId&) = default;
};

struct JsonValue {
  JsonKind kind = JsonKind::Null;
  Span span;            ///< bytes of the file
  bool truth = false;   ///< of Boolean
  double number = 0;    ///< of Number; finite
  bool whole = false;   ///< of Number: written without fraction and exponent, and an int64_t
  int64_t integer = 0;  ///< where `whole`
  std::string text;     ///< of String, without escapes
  std::vector<JsonId> elements = {};

  JsonId parent;         ///< of the root: itself
  uint32_t index = 0;    ///< among the parent's elements
  std::string key = {};  ///< where the parent is an object
  Span key_span;
};

/// A text of JSON with the place of each value. Beyond what JSON allows, strings may hold line breaks and tabs.
class JsonTree {
 public:
  const JsonValue& operator[](JsonId id) const { return values_[id.value]; }
  const JsonValue& root() const { return values_.front(); }
  uint32_t size() const { return static_cast<uint32_t>(values_.size()); }

  /// How a person names the value: `scene[0].children[2].data`; empty for the root.
  std::string path(JsonId id) const;
  std::string path_of_key(JsonId object, std::string_view key) const;

 private:
  friend class JsonTreeBuilder;
  std::vector<JsonValue> values_;
};

/// Why a text is no JSON, and where.
struct JsonFault {
  Span span;
  std::string message;
};

inline constexpr uint32_t kMaxJsonBytes = 8U << 20U;
inline constexpr uint32_t kMaxJsonDepth = 256;
inline constexpr uint32_t kMaxJsonValues = 1'000'000;

/// Fails on what is no JSON, on an object with a key twice, on numbers that are not finite, and beyond the limits
/// above.
std::variant<JsonTree, JsonFault> parse_json(std::string_view text);

}  // namespace texbrdf::scene_json
