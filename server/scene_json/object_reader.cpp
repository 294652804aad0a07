#include "scene_json/object_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "semantics/nearest_name.h"

namespace texbrdf::scene_json {
namespace {

constexpr uint64_t kSuggestionSteps = 100'000;
constexpr double kLargestFloat = std::numeric_limits<float>::max();

std::string shown(const JsonValue& value) {
  switch (value.kind) {
    case JsonKind::Boolean:
      return value.truth ? "true" : "false";
    case JsonKind::Number:
      return fmt::format("the number {}", value.number);
    case JsonKind::Null:
    case JsonKind::String:
    case JsonKind::Array:
    case JsonKind::Object:
      return std::string(described(value.kind));
  }
  return {};
}

}  // namespace

std::string suggestion(std::string_view wanted, std::span<const std::string> names) {
  NearestName nearest;
  for (const std::string& name : names) nearest.add(name);
  uint64_t steps = kSuggestionSteps;
  const std::optional<std::string> found = nearest.find(wanted, steps);
  return found ? fmt::format(" (did you mean `{}`?)", *found) : std::string();
}

bool FileReader::expect(JsonId id, JsonKind kind) {
  const JsonValue& value = (*this)[id];
  if (value.kind == kind) return true;
  fail(id, fmt::format("this has to be {}, not {}", described(kind), shown(value)));
  return false;
}

std::optional<double> FileReader::number(JsonId id) {
  return number(id, -kLargestFloat, kLargestFloat);
}

std::optional<double> FileReader::number(JsonId id, double minimum, double maximum) {
  if (!expect(id, JsonKind::Number)) return std::nullopt;
  const double number = (*this)[id].number;
  if (std::abs(number) > kLargestFloat) {
    fail(id, fmt::format("{} is too large for single precision", number));
    return std::nullopt;
  }
  if (number < minimum || number > maximum) {
    fail(id, maximum < kLargestFloat ? fmt::format("{} is not between {} and {}", number, minimum, maximum)
                                     : fmt::format("{} is less than {}", number, minimum));
    return std::nullopt;
  }
  return number;
}

std::optional<int64_t> FileReader::whole(JsonId id, int64_t minimum, int64_t maximum) {
  if (!expect(id, JsonKind::Number)) return std::nullopt;
  const JsonValue& value = (*this)[id];
  if (!value.whole) {
    fail(id, fmt::format("this has to be a whole number, not {}", value.number));
    return std::nullopt;
  }
  if (value.integer < minimum || value.integer > maximum) {
    fail(id, fmt::format("{} is not between {} and {}", value.integer, minimum, maximum));
    return std::nullopt;
  }
  return value.integer;
}

std::optional<bool> FileReader::boolean(JsonId id) {
  if (!expect(id, JsonKind::Boolean)) return std::nullopt;
  return (*this)[id].truth;
}

std::optional<std::string> FileReader::text(JsonId id) {
  if (!expect(id, JsonKind::String)) return std::nullopt;
  return (*this)[id].text;
}

std::optional<std::string> FileReader::text_that_is_not_empty(JsonId id) {
  std::optional<std::string> read = text(id);
  if (!read || !read->empty()) return read;
  fail(id, "this must not be empty");
  return std::nullopt;
}

std::span<const JsonId> FileReader::list(JsonId id) {
  if (!expect(id, JsonKind::Array)) return {};
  return (*this)[id].elements;
}

std::optional<std::vector<double>> FileReader::numbers(JsonId id, std::size_t least, std::size_t most) {
  if (!expect(id, JsonKind::Array)) return std::nullopt;
  const std::vector<JsonId>& elements = (*this)[id].elements;
  if (elements.size() < least || elements.size() > most) {
    const std::string count = least == most ? fmt::format("{}", most)
                              : least == 0  ? fmt::format("at most {}", most)
                                            : fmt::format("{} to {}", least, most);
    fail(id,
         fmt::format("this has to be a list of {} number{}, not of {}", count, most == 1 ? "" : "s", elements.size()));
    return std::nullopt;
  }
  std::vector<double> numbers;
  for (const JsonId element : elements) {
    if (const auto read = number(element)) numbers.push_back(*read);
  }
  if (numbers.size() != elements.size()) return std::nullopt;
  return numbers;
}

ObjectReader::ObjectReader(FileReader& file, JsonId object)
    : file_(file), object_(object), valid_(file.expect(object, JsonKind::Object)) {}

std::optional<JsonId> ObjectReader::member(std::string_view key) {
  known_.emplace_back(key);
  if (!valid_) return std::nullopt;
  for (const JsonId id : file_[object_].elements) {
    if (file_[id].key == key) return id;
  }
  return std::nullopt;
}

std::optional<JsonId> ObjectReader::required(std::string_view key) {
  const std::optional<JsonId> found = member(key);
  if (!found && valid_) file_.fail(object_, fmt::format("the key `{}` is missing", key));
  return found;
}

void ObjectReader::finish() {
  if (!valid_) return;
  for (const JsonId id : file_[object_].elements) {
    const JsonValue& value = file_[id];
    if (std::ranges::find(known_, value.key) != known_.end()) continue;
    const std::string nearest = file_.is_full() ? std::string() : suggestion(value.key, known_);
    file_.fail_key(object_, value, fmt::format("the key `{}` is not known here{}", value.key, nearest));
  }
}

}  // namespace texbrdf::scene_json
