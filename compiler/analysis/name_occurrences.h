#pragma once

#include <compare>
#include <tuple>

#include "analysis/segment.h"
#include "semantics/names.h"

namespace texbrdf {

/// A definition, as long as its block stays.
struct DefinitionKey {
  BlockLabel block = 0;
  uint32_t index_in_block = 0;
  Standing standing = Standing::Display;

  constexpr std::tuple<BlockLabel, uint32_t> place() const { return {block, index_in_block}; }

  using Measure = DefinitionKey;  ///< of a list: its greatest key
  Measure measure() const { return *this; }
  friend DefinitionKey operator+(const DefinitionKey& a, const DefinitionKey& b) { return std::max(a, b); }
  friend constexpr bool operator==(const DefinitionKey& a, const DefinitionKey& b) {
    return a.block == b.block && a.index_in_block == b.index_in_block;
  }
  friend constexpr std::strong_ordering operator<=>(const DefinitionKey& a, const DefinitionKey& b) {
    if (a.standing != b.standing) return a.standing <=> b.standing;
    return a.standing == Standing::Value ? b.place() <=> a.place() : a.place() <=> b.place();
  }
};

/// A block that mentions a name.
struct UserKey {
  BlockLabel block = 0;

  using Measure = UserKey;
  Measure measure() const { return *this; }
  friend UserKey operator+(const UserKey& a, const UserKey& b) { return std::max(a, b); }
  friend constexpr auto operator<=>(const UserKey&, const UserKey&) = default;
};

/// Where a name occurs, in document order; its definitions in order of standing first.
struct NameOccurrences {
  Sequence<DefinitionKey> definitions;
  Sequence<UserKey> users;

  struct Measure {
    friend Measure operator+(const Measure&, const Measure&) { return {}; }
  };
  Measure measure() const { return {}; }
};

/// By NameId.
using OccurrencesByName = Sequence<NameOccurrences>;

template <typename Key>
void insert_key(Sequence<Key>& keys, const Key& key) {
  const auto place = keys.find([&](const Key& greatest) { return greatest >= key; });
  if (place.item != nullptr && *place.item == key) return;
  keys = keys.with(place.index, 0, std::span(&key, 1));
}

template <typename Key>
void erase_key(Sequence<Key>& keys, const Key& key) {
  const auto place = keys.find([&](const Key& greatest) { return greatest >= key; });
  if (place.item != nullptr && *place.item == key) keys = keys.with(place.index, 1, {});
}

}  // namespace texbrdf
