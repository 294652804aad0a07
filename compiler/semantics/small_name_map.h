#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "semantics/names.h"

namespace texbrdf {

/// Positions of names in order of insertion. A few names are compared one by one, many are hashed, so that neither
/// the usual definition nor a huge one is slow.
class SmallNameMap {
 public:
  std::optional<uint32_t> find(NameId name) const {
    if (!many_.empty()) {
      const auto found = positions_.find(name.value);
      return found == positions_.end() ? std::nullopt : std::optional(found->second);
    }
    const auto found = std::find(few_.begin(), few_.begin() + count_, name);
    return found == few_.begin() + count_ ? std::nullopt : std::optional(static_cast<uint32_t>(found - few_.begin()));
  }

  /// False where the name was there already.
  bool insert(NameId name) {
    if (find(name)) return false;
    if (count_ < few_.size()) {
      few_[count_++] = name;
    } else {
      if (many_.empty()) hash_few();
      add_to_many(name);
    }
    return true;
  }

  std::span<const NameId> names() const { return many_.empty() ? std::span(few_).first(count_) : std::span(many_); }

 private:
  void hash_few() {
    for (const NameId name : few_) add_to_many(name);
  }

  void add_to_many(NameId name) {
    positions_.emplace(name.value, static_cast<uint32_t>(many_.size()));
    many_.push_back(name);
  }

  std::array<NameId, 24> few_;
  uint32_t count_ = 0;
  std::vector<NameId> many_;  // all, once they are no longer few
  std::unordered_map<uint32_t, uint32_t> positions_;
};

}  // namespace texbrdf
