#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "semantics/stable_list.h"

namespace texbrdf {

/// Strings numbered from 0 in order of insertion, each with a payload, and the way back. Nothing ever moves, so one
/// writer may insert while others read what was inserted before.
template <typename Payload>
class StringIndex {
 public:
  static constexpr uint32_t kNone = UINT32_MAX;

  StringIndex() { grow(128); }

  uint32_t size() const { return entries_.size(); }
  std::string_view text(uint32_t index) const { return entries_[index].text; }
  const Payload& payload(uint32_t index) const { return entries_[index].payload; }

  uint32_t find(std::string_view text) const {
    const uint32_t hash_of_text = hash(text);
    const Slots& slots = *slots_.load(std::memory_order_acquire);
    for (uint32_t slot = hash_of_text & slots.mask;; slot = (slot + 1) & slots.mask) {
      const uint32_t index = slots.indices[slot].load(std::memory_order_acquire);
      if (index == kNone) return kNone;
      const Entry& candidate = entries_[index];
      if (candidate.hash == hash_of_text && candidate.text == text) return index;
    }
  }

  /// Precondition: `text` is not in the index.
  uint32_t insert(std::string_view text, Payload payload) {
    const uint32_t index = entries_.append({store(text), hash(text), std::move(payload)});
    Slots* slots = slots_.load(std::memory_order_relaxed);
    if (size() * 2 > slots->mask) {
      grow((slots->mask + 1) * 4);
    } else {
      put(*slots, index);
    }
    return index;
  }

 private:
  static constexpr size_t kArenaBytes = 1 << 14;

  struct Entry {
    std::string_view text;
    uint32_t hash = 0;
    Payload payload{};
  };
  struct Slots {
    uint32_t mask;
    std::unique_ptr<std::atomic<uint32_t>[]> indices;
  };

  static uint64_t load(const char* bytes, size_t count) {
    uint64_t word = 0;
    std::memcpy(&word, bytes, count);
    return word;
  }

  static uint64_t mix(uint64_t state, uint64_t word) {
    state = (state ^ word) * 0xff51afd7ed558ccdu;
    return state ^ (state >> 32);
  }

  static uint32_t hash(std::string_view text) {
    const size_t size = text.size();
    const char* const bytes = text.data();
    uint64_t state = size * 0x9e3779b97f4a7c15u;
    if (size >= 8) {
      // The last word overlaps the one before it.
      for (size_t i = 0; i + 8 < size; i += 8) state = mix(state, load(bytes + i, 8));
      state = mix(state, load(bytes + size - 8, 8));
    } else if (size >= 4) {
      state = mix(state, load(bytes, 4) | load(bytes + size - 4, 4) << 32);
    } else if (size > 0) {
      const auto byte = [&](size_t i) { return static_cast<uint64_t>(static_cast<unsigned char>(bytes[i])); };
      state = mix(state, byte(0) | byte(size / 2) << 8 | byte(size - 1) << 16);
    }
    return static_cast<uint32_t>(state ^ (state >> 29));
  }

  void put(Slots& slots, uint32_t index) {
    uint32_t slot = entries_[index].hash & slots.mask;
    while (slots.indices[slot].load(std::memory_order_relaxed) != kNone) slot = (slot + 1) & slots.mask;
    slots.indices[slot].store(index, std::memory_order_release);
  }

  void grow(uint32_t capacity) {
    auto slots = std::make_unique<Slots>(Slots{capacity - 1, std::make_unique<std::atomic<uint32_t>[]>(capacity)});
    for (uint32_t slot = 0; slot < capacity; ++slot) slots->indices[slot].store(kNone, std::memory_order_relaxed);
    for (uint32_t index = 0; index < size(); ++index) put(*slots, index);
    slots_.store(slots.get(), std::memory_order_release);
    retained_.push_back(std::move(slots));
  }

  std::string_view store(std::string_view text) {
    if (text.size() > free_.size()) {
      const size_t bytes = std::max(kArenaBytes, text.size());
      arena_.push_back(std::make_unique<char[]>(bytes));
      free_ = {arena_.back().get(), bytes};
    }
    if (!text.empty()) std::memcpy(free_.data(), text.data(), text.size());
    const std::string_view kept(free_.data(), text.size());
    free_ = free_.subspan(text.size());
    return kept;
  }

  StableList<Entry> entries_;
  std::atomic<Slots*> slots_ = nullptr;
  std::vector<std::unique_ptr<Slots>> retained_;  // smaller ones too: a reader may still look into them
  std::vector<std::unique_ptr<char[]>> arena_;
  std::span<char> free_;
};

}  // namespace texbrdf
