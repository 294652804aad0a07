#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene_json/problem.h"

namespace texbrdf::scene_json {

/// The name nearest to a wrong one: " (did you mean `x`?)"; empty where none is near.
std::string suggestion(std::string_view wanted, std::span<const std::string> names);

/// Reads the values of a file. What does not fit is reported, and reads as nothing.
class FileReader {
 public:
  FileReader(const JsonFile& file, Problems& problems) : file_(file), problems_(problems) {}

  const JsonFile& file() const { return file_; }
  const JsonValue& operator[](JsonId id) const { return file_.tree[id]; }
  void fail(JsonId where, std::string message) { problems_.add(file_, where, std::move(message)); }
  void fail_key(JsonId object, const JsonValue& member, std::string message) {
    problems_.add_key(file_, object, member, std::move(message));
  }
  void warn(JsonId where, std::string message) { problems_.warn(file_, where, std::move(message)); }
  bool is_full() const { return problems_.is_full(); }
  /// What tells whether something was reported since.
  uint32_t error_count() const { return problems_.error_count(); }

  /// False, and reported, where it is of another kind.
  bool expect(JsonId id, JsonKind kind);
  /// Of a size that single precision holds.
  std::optional<double> number(JsonId id);
  std::optional<double> number(JsonId id, double minimum, double maximum);
  std::optional<int64_t> whole(JsonId id, int64_t minimum, int64_t maximum);
  std::optional<bool> boolean(JsonId id);
  std::optional<std::string> text(JsonId id);
  std::optional<std::string> text_that_is_not_empty(JsonId id);
  /// The elements of a list; none where it is none.
  std::span<const JsonId> list(JsonId id);
  /// The numbers of a list of at most `most`.
  std::optional<std::vector<double>> numbers(JsonId id, std::size_t least, std::size_t most);

 private:
  const JsonFile& file_;
  Problems& problems_;
};

/// Reads the members of an object. `finish` reports the keys that nobody asked for.
class ObjectReader {
 public:
  ObjectReader(FileReader& file, JsonId object);

  /// False where it is no object, which has been reported.
  bool valid() const { return valid_; }
  std::optional<JsonId> member(std::string_view key);
  std::optional<JsonId> required(std::string_view key);
  void finish();

 private:
  FileReader& file_;
  JsonId object_;
  bool valid_;
  std::vector<std::string> known_;
};

}  // namespace texbrdf::scene_json
