#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

namespace texbrdf {

/// A list whose elements never move: one writer may append while others read what was there before.
template <typename T>
class StableList {
 public:
  uint32_t size() const { return size_; }

  const T& operator[](uint32_t index) const {
    const auto [chunk, offset] = locate(index);
    return chunks_[chunk][offset];
  }

  uint32_t append(T value) {
    const auto [chunk, offset] = locate(size_);
    if (!chunks_[chunk]) chunks_[chunk] = std::make_unique<T[]>(size_t{kFirstChunk} << chunk);
    chunks_[chunk][offset] = std::move(value);
    return size_++;
  }

 private:
  static constexpr uint32_t kFirstChunk = 64;  // each chunk is twice as long as the one before
  static constexpr size_t kChunks = 26;

  struct Place {
    uint32_t chunk, offset;
  };
  static Place locate(uint32_t index) {
    const auto chunk = static_cast<uint32_t>(std::bit_width((index / kFirstChunk + 1) / 2));
    return {chunk, index - kFirstChunk * ((uint32_t{1} << chunk) - 1)};
  }

  uint32_t size_ = 0;
  std::array<std::unique_ptr<T[]>, kChunks> chunks_;
};

}  // namespace texbrdf
