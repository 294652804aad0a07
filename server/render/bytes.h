#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace texbrdf::render {

/// Appends values as they lie in memory: both ends of the protocol are the same program on the same machine.
class ByteWriter {
 public:
  template <typename T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    append(&value, sizeof value);
  }
  void put(std::string_view text) {
    put(static_cast<uint32_t>(text.size()));
    append(text.data(), text.size());
  }
  template <typename T>
  void put(std::span<const T> values) {
    static_assert(std::is_arithmetic_v<T>);
    put(static_cast<uint32_t>(values.size()));
    append(values.data(), values.size_bytes());
  }
  std::vector<uint8_t> take() { return std::move(bytes_); }

 private:
  void append(const void* data, std::size_t size) {
    const auto* from = static_cast<const uint8_t*>(data);
    bytes_.insert(bytes_.end(), from, from + size);
  }
  std::vector<uint8_t> bytes_;
};

/// Reads what ByteWriter wrote, from bytes that may be anything. After the first value that is not there all others are
/// zero or empty.
class ByteReader {
 public:
  explicit ByteReader(std::span<const uint8_t> bytes) : rest_(bytes) {}

  template <typename T>
  T get() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    copy(&value, 1, sizeof value);
    return value;
  }
  std::string get_text() {
    std::string text;
    fill(text);
    return text;
  }
  template <typename T>
  std::vector<T> get_list() {
    std::vector<T> values;
    fill(values);
    return values;
  }
  /// Everything was there, and nothing is left over.
  bool complete() const { return !failed_ && rest_.empty(); }

 private:
  template <typename Container>
  void fill(Container& container) {
    const auto count = get<uint32_t>();
    if (failed_ || count > rest_.size() / sizeof(typename Container::value_type)) {
      failed_ = true;
      return;
    }
    container.resize(count);
    copy(container.data(), count, sizeof(typename Container::value_type));
  }
  void copy(void* to, std::size_t count, std::size_t size) {
    if (failed_ || rest_.size() < count * size) {
      failed_ = true;
      return;
    }
    if (count > 0) std::memcpy(to, rest_.data(), count * size);
    rest_ = rest_.subspan(count * size);
  }
  std::span<const uint8_t> rest_;
  bool failed_ = false;
};

}  // namespace texbrdf::render
