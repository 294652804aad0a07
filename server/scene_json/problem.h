#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "scene_json/json_tree.h"
#include "source/source_text.h"

namespace texbrdf::scene_json {

/// Something wrong in one of a scene's files.
struct Problem {
  Severity severity = Severity::Error;
  std::string file;       ///< real path
  std::string json_path;  ///< `scene[0].children[2].data`; empty: the file as a whole
  Span span;              ///< bytes of the file
  uint32_t line = 1;      ///< of the span's begin, from 1
  uint32_t column = 1;    ///< from 1, in code points
  std::string message;
};

/// The path from `folder` (real) where it is below.
std::string_view path_from(std::string_view path, std::string_view folder);

/// `file(line:column) error: scene[0].data: message`, without a line break; the file as `path_from`
/// says it.
std::string describe(const Problem& problem, std::string_view folder = {});

/// A file that was read.
struct JsonFile {
  std::string path;  ///< real
  SourceText text;
  JsonTree tree;
};

/// Collects problems, up to kMaxProblems.
class Problems {
 public:
  static constexpr std::size_t kMaxProblems = 100;

  void add(const JsonFile& file, JsonId where, std::string message) {
    add(file.path, file.text, file.tree.path(where), file.tree[where].span, std::move(message));
  }
  void add_key(const JsonFile& file, JsonId object, const JsonValue& member, std::string message) {
    add(file.path, file.text, file.tree.path_of_key(object, member.key), member.key_span, std::move(message));
  }
  void add(const std::string& path, const SourceText& text, std::string json_path, Span span, std::string message);
  void warn(const JsonFile& file, JsonId where, std::string message);

  /// What is reported now is only counted.
  bool is_full() const { return problems_.size() >= kMaxProblems; }
  bool has_error() const { return error_count_ > 0; }
  /// How many errors there are, those included that were not kept.
  uint32_t error_count() const { return error_count_; }
  std::vector<Problem> take() { return std::move(problems_); }

 private:
  std::vector<Problem> problems_;
  uint32_t error_count_ = 0;
};

}  // namespace texbrdf::scene_json
