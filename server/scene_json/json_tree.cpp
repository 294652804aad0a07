#include "scene_json/json_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>
#include <utility>

#include "source/utf8.h"

namespace texbrdf::scene_json {

namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// What stands in the place of a character that JSON forbids in strings; empty for all others.
std::string_view escape_of(char c) {
  switch (c) {
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    case '\t':
      return "\\t";
    default:
      return {};
  }
}

/// The text with line breaks and tabs in strings escaped, and where each byte was that has moved.
class StrictText {
 public:
  explicit StrictText(std::string_view text) {
    bytes_.reserve(text.size());
    bool in_string = false;
    bool escaped = false;
    for (const char c : text) {
      const std::string_view escape = in_string && !escaped ? escape_of(c) : std::string_view();
      if (!escape.empty()) {
        inserted_.push_back(bytes_.size());
        bytes_ += escape;
        continue;
      }
      if (c == '"' && !escaped) in_string = !in_string;
      escaped = in_string && !escaped && c == '\\';
      bytes_ += c;
    }
  }

  const std::string& bytes() const { return bytes_; }
  std::size_t original(std::size_t offset) const {
    return offset - static_cast<std::size_t>(std::ranges::lower_bound(inserted_, offset) - inserted_.begin());
  }

 private:
  std::string bytes_;
  std::vector<std::size_t> inserted_;  // where one byte became two
};

/// Finds the places of tokens in well-formed text, one after the other.
class TokenPlaces {
 public:
  explicit TokenPlaces(std::string_view text) : text_(text) {
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  }

  Span next() {
    at_ = std::min(text_.find_first_not_of(" \t\r\n,:", at_), text_.size());
    const std::size_t begin = at_;
    if (begin == text_.size()) return span(begin);
    if (text_[begin] == '"') {
      skip_string();
    } else if (std::string_view("[]{}").find(text_[begin]) != std::string_view::npos) {
      ++at_;
    } else {
      at_ = std::min(text_.find_first_of(" \t\r\n,:[]{}\"", at_), text_.size());
    }
    return span(begin);
  }

 private:
  Span span(std::size_t begin) const { return {static_cast<uint32_t>(begin), static_cast<uint32_t>(at_)}; }
  void skip_string() {
    at_ = text_.find_first_of("\"\\", at_ + 1);
    while (at_ != std::string_view::npos && text_[at_] == '\\') at_ = text_.find_first_of("\"\\", at_ + 2);
    at_ = at_ == std::string_view::npos ? text_.size() : at_ + 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

/// Of "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while parsing value - invalid
/// literal; last read: 'x'" that the literal is invalid.
std::string reason_of(std::string_view what) {
  for (const std::string_view mark : {"] ", "column ", ": ", " - "}) {
    const std::size_t found = what.find(mark);
    if (found != std::string_view::npos) what.remove_prefix(found + mark.size());
  }
  return "no JSON: " + printable(what.substr(0, what.find("; last read")));
}

}  // namespace

/// Called by the parser of nlohmann-json for each token; false ends the parsing.
class JsonTreeBuilder {
 public:
  JsonTreeBuilder(std::string_view text, const StrictText& strict)
      : strict_(strict), places_(text), size_(text.size()) {}

  JsonTree take_tree() { return std::move(tree_); }
  JsonFault take_fault() { return fault_ ? std::move(*fault_) : JsonFault{{}, "this is no JSON"}; }

  bool null() { return add(JsonKind::Null).has_value(); }
  bool boolean(bool truth) {
    const auto id = add(JsonKind::Boolean);
    if (id) at(*id).truth = truth;
    return id.has_value();
  }
  bool number_integer(int64_t number) { return add_whole(static_cast<double>(number), number); }
  bool number_unsigned(uint64_t number) {
    if (number > static_cast<uint64_t>(std::numeric_limits<int64_t>::max())) {
      return add_number(static_cast<double>(number));
    }
    return add_whole(static_cast<double>(number), static_cast<int64_t>(number));
  }
  bool number_float(double number, const std::string&) { return add_number(number); }
  bool string(std::string& text) {
    const auto id = add(JsonKind::String);
    if (id) at(*id).text = std::move(text);
    return id.has_value();
  }
  bool binary(nlohmann::json::binary_t&) { return false; }

  bool start_object(std::size_t) { return open(JsonKind::Object); }
  bool start_array(std::size_t) { return open(JsonKind::Array); }
  bool end_object() { return close(); }
  bool end_array() { return close(); }

  bool key(std::string& text) {
    key_span_ = places_.next();
    key_ = std::move(text);
    if (keys_.back().insert(key_).second) return true;
    return fail(key_span_, fmt::format("the key `{}` stands here twice", key_));
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& error) {
    // The position counts the bytes read, the offending one included.
    const std::size_t last = strict_.original(position == 0 ? 0 : position - 1);
    const auto begin = static_cast<uint32_t>(std::min(last, size_));
    return fail({begin, static_cast<uint32_t>(std::min<std::size_t>(begin + 1, size_))}, reason_of(error.what()));
  }

 private:
  JsonValue& at(JsonId id) { return tree_.values_[id.value]; }

  std::optional<JsonId> add(JsonKind kind) {
    const Span span = places_.next();
    const JsonId id{tree_.size()};
    if (id.value >= kMaxJsonValues) {
      fail(span, fmt::format("more than {} values", kMaxJsonValues));
      return std::nullopt;
    }
    JsonValue& value = tree_.values_.emplace_back();
    value.kind = kind;
    value.span = span;
    if (open_.empty()) return id;
    JsonValue& parent = at(open_.back());
    value.parent = open_.back();
    value.index = static_cast<uint32_t>(parent.elements.size());
    parent.elements.push_back(id);
    if (parent.kind == JsonKind::Object) {
      value.key = std::move(key_);
      value.key_span = key_span_;
    }
    return id;
  }

  bool add_number(double number) {
    const auto id = add(JsonKind::Number);
    if (!id) return false;
    if (!std::isfinite(number)) return fail(at(*id).span, "the number is too large");
    at(*id).number = number;
    return true;
  }

  bool add_whole(double number, int64_t integer) {
    if (!add_number(number)) return false;
    JsonValue& value = tree_.values_.back();
    value.whole = true;
    value.integer = integer;
    return true;
  }

  bool open(JsonKind kind) {
    const auto id = add(kind);
    if (!id) return false;
    if (open_.size() >= kMaxJsonDepth) return fail(at(*id).span, fmt::format("nested deeper than {}", kMaxJsonDepth));
    open_.push_back(*id);
    keys_.emplace_back();
    return true;
  }

  bool close() {
    at(open_.back()).span.end = places_.next().end;
    open_.pop_back();
    keys_.pop_back();
    return true;
  }

  bool fail(Span span, std::string message) {
    if (!fault_) fault_ = JsonFault{span, std::move(message)};
    return false;
  }

  const StrictText& strict_;
  TokenPlaces places_;
  std::size_t size_;
  JsonTree tree_;
  std::vector<JsonId> open_;
  std::vector<std::unordered_set<std::string>> keys_;  // of the objects that are open
  std::string key_;
  Span key_span_;
  std::optional<JsonFault> fault_;
};

std::string_view described(JsonKind kind) {
  switch (kind) {
    case JsonKind::Null:
      return "null";
    case JsonKind::Boolean:
      return "true or false";
    case JsonKind::Number:
      return "a number";
    case JsonKind::String:
      return "a string";
    case JsonKind::Array:
      return "a list";
    case JsonKind::Object:
      return "an object";
  }
  return {};
}

std::string JsonTree::path_of_key(JsonId object, std::string_view key) const {
  const bool is_word = !key.empty() && std::ranges::all_of(key, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '$';
  });
  const std::string parent = path(object);
  if (!is_word) return fmt::format("{}[\"{}\"]", parent, key);
  return parent.empty() ? std::string(key) : fmt::format("{}.{}", parent, key);
}

std::string JsonTree::path(JsonId id) const {
  const JsonValue& value = (*this)[id];
  if (id.value == 0) return {};
  if ((*this)[value.parent].kind == JsonKind::Object) return path_of_key(value.parent, value.key);
  return fmt::format("{}[{}]", path(value.parent), value.index);
}

std::variant<JsonTree, JsonFault> parse_json(std::string_view text) {
  if (text.size() > kMaxJsonBytes) return JsonFault{{}, fmt::format("longer than {} bytes", kMaxJsonBytes)};
  const StrictText strict(text);
  JsonTreeBuilder builder(text, strict);
  if (!nlohmann::json::sax_parse(strict.bytes(), &builder)) return builder.take_fault();
  return builder.take_tree();
}

}  // namespace texbrdf::scene_json
