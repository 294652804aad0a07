#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

namespace texbrdf::lsp {

/// Writes JSON straight to text, with commas where they belong. The caller pairs begin and end and gives each member
/// of an object a key. Bytes that are no UTF-8 become U+FFFD, so the text is always valid JSON.
class JsonWriter {
 public:
  void begin_object() { open('{'); }
  void end_object() { close('}'); }
  void begin_array() { open('['); }
  void end_array() { close(']'); }

  /// `name` is ASCII that needs no escapes.
  void key(std::string_view name);
  /// Any text as a key.
  void text_key(std::string_view name);

  void value(std::string_view text);
  void value(const char* text) { value(std::string_view(text)); }
  void value(bool truth) { raw(truth ? "true" : "false"); }
  void value(std::signed_integral auto number) { integer(number); }
  void value(std::unsigned_integral auto number) { natural(number); }
  /// The shortest digits that read back exactly; null for NaN and infinities, which JSON lacks.
  void value(double number);
  void null() { raw("null"); }
  /// A value that is JSON already.
  void raw(std::string_view json);

  void member(std::string_view name, const auto& content) {
    key(name);
    value(content);
  }

  /// Room for so many more bytes and what usually stands around them, so that a large result is not copied while it
  /// grows.
  void reserve(std::size_t bytes) { text_.reserve(text_.size() + bytes + kUsualFrameBytes); }

  const std::string& text() const { return text_; }
  std::string take() { return std::move(text_); }

 private:
  static constexpr std::size_t kUsualFrameBytes = 64;

  void separate();
  void open(char bracket);
  void close(char bracket);
  void quoted(std::string_view text);
  void integer(int64_t number);
  void natural(uint64_t number);

  std::string text_;
  bool comma_ = false;  ///< a value stands before the next one
};

}  // namespace texbrdf::lsp
