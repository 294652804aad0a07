#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "semantics/names.h"

namespace texbrdf {

/// Positions of names in order of insertion. A few names are compared one by one, many are hashed, so that neither
/// the usual definition nor a huge one is slow.
class SmallNameMap {
 public:
  std::optional<uint32_t> find(NameId name) const {
    if (names_.size() > kFew) {
      const auto found = positions_.find(name.value);
      return found == positions_.end() ? std::nullopt : std::optional(found->second);
    }
    for (uint32_t i = 0; i < names_.size(); ++i) {
      if (names_[i] == name) return i;
    }
    return std::nullopt;
  }

  /// False where the name was there already.
  bool insert(NameId name) {
    if (find(name)) return false;
    if (names_.empty()) names_.reserve(kUsual);
    names_.push_back(name);
    if (names_.size() == kFew + 1) {
      for (uint32_t i = 0; i < names_.size(); ++i) positions_.emplace(names_[i].value, i);
    } else if (names_.size() > kFew) {
      positions_.emplace(name.value, static_cast<uint32_t>(names_.size() - 1));
    }
    return true;
  }

  const std::vector<NameId>& names() const { return names_; }
  std::vector<NameId> take() { return std::move(names_); }

 private:
  static constexpr size_t kUsual = 8;
  static constexpr size_t kFew = 24;
  std::vector<NameId> names_;
  std::unordered_map<uint32_t, uint32_t> positions_;
};

}  // namespace texbrdf
