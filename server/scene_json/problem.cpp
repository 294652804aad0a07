#include "scene_json/problem.h"

#include <fmt/format.h>

#include <utility>

#include "source/utf8.h"

namespace texbrdf::scene_json {

std::string_view path_from(std::string_view path, std::string_view folder) {
  if (!folder.empty() && path.starts_with(folder) && path.substr(folder.size()).starts_with('/')) {
    path.remove_prefix(folder.size() + 1);
  }
  return path;
}

std::string describe(const Problem& problem, std::string_view folder) {
  const std::string_view file = path_from(problem.file, folder);
  const std::string where = problem.json_path.empty() ? std::string() : problem.json_path + ": ";
  return printable(fmt::format("{}({}:{}) {}: {}{}", file, problem.line, problem.column,
                               severity_name(problem.severity), where, problem.message));
}

void Problems::add(const std::string& path, const SourceText& text, std::string json_path, Span span,
                   std::string message) {
  ++error_count_;
  if (problems_.size() >= kMaxProblems) return;
  const Position at = text.position(span.begin, ColumnUnit::CodePoint);
  problems_.push_back(
      {Severity::Error, path, std::move(json_path), span, at.line + 1, at.column + 1, std::move(message)});
}

void Problems::warn(const JsonFile& file, JsonId where, std::string message) {
  const std::size_t before = problems_.size();
  const uint32_t errors = error_count_;
  add(file, where, std::move(message));
  error_count_ = errors;
  if (problems_.size() > before) problems_.back().severity = Severity::Warning;
}

}  // namespace texbrdf::scene_json
