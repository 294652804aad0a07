#include "semantics/bound_names.h"

#include <algorithm>
#include <string>
#include <utility>

namespace texbrdf {
namespace {

/// Of all names that a block's names may stand for.
constexpr size_t kMostImplied = 20'000;
constexpr size_t kMostOfOneName = 256;

/// The items of a subscript, at its commas outside of braces.
std::vector<std::string> items_of(std::string_view subscript) {
  std::vector<std::string> items(1);
  int depth = 0;
  for (const char c : subscript) {
    if (c == '{') ++depth;
    if (c == '}') --depth;
    if (c == ',' && depth == 0) {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

std::string joined(const std::vector<std::string>& items) {
  std::string text;
  for (size_t i = 0; i < items.size(); ++i) {
    if (i > 0) text += ',';
    text += items[i];
  }
  return text;
}

/// Where an index stands in a name.
struct IndexPlace {
  uint32_t binder;
  size_t subscript;
  size_t item;
};

class BoundNameReader {
 public:
  BoundNameReader(const ParsedBlock& block, NameTable& table, BlockNames& names)
      : block_(block), table_(table), names_(names), open_(names.binders) {}

  void run() {
    for (uint32_t i = 0; i < names_.binders.size(); ++i) {
      if (names_.binders[i].range.valid()) names_.bound.push_back({names_.binders[i].variable, i});
    }
    for (uint32_t node = 0; node < names_.by_node.size(); ++node) {
      open_.advance_to(node);
      if (names_.by_node[node].valid()) read(NodeId{node});
    }
    std::ranges::sort(names_.bound, {}, &BoundUse::node);
  }

 private:
  void read(NodeId node) {
    const std::span<const uint32_t> open = open_.open();
    const size_t first = open.size() - std::min(open.size(), kMostNestedBinders);
    for (size_t i = open.size(); i-- > first;) {
      if (name(names_.binders[open[i]].variable) != name(node)) continue;
      names_.bound.push_back({node, open[i]});
      return;
    }
    if (names_.binders.empty() && !may_be_derivative(node)) return;
    if (read_indexed(node, open.subspan(first)) || !may_be_derivative(node)) return;
    Name function = read_name(block_, node);
    StandIn stand_in{node, {}, {}};
    const uint32_t primes = std::exchange(function.primes, 0);
    for (; function.primes < primes; ++function.primes)
      stand_in.names.push_back(table_.intern(canonical_form(function)));
    if (primes > 0) add(std::move(stand_in));
  }

  NameId name(NodeId node) const { return names_.by_node[node.value]; }

  /// `f'(x)`, `f''(x)`
  bool may_be_derivative(NodeId node) const {
    constexpr uint32_t kMostPrimes = 4;
    const Node& n = block_.tree.node(node);
    if (block_.tokens[n.end_token].kind != TokenKind::OpenParen) return false;
    uint32_t primes = 0;
    for (uint32_t token = n.end_token; token > n.first_token && is_of_primes(block_.tokens[token - 1].kind); --token) {
      if (block_.tokens[token - 1].kind == TokenKind::Prime) ++primes;
    }
    return primes > 0 && primes <= kMostPrimes;
  }

  /// `'` or `^{\prime\prime}`
  static bool is_of_primes(TokenKind kind) {
    return kind == TokenKind::Prime || kind == TokenKind::Caret || kind == TokenKind::OpenBrace ||
           kind == TokenKind::CloseBrace;
  }

  bool read_indexed(NodeId node, std::span<const uint32_t> open) {
    const Node& n = block_.tree.node(node);
    if (open.empty() || n.end_token - n.first_token < 3) return false;
    const Name indexed = read_name(block_, node);
    std::vector<IndexPlace> places;
    for (size_t i = 0; i < indexed.subscripts.size(); ++i) find_places(indexed, i, open, places);
    if (places.empty()) return false;
    StandIn stand_in{node, {}, {}};
    size_t count = 1;
    for (const uint32_t binder : open) {
      if (std::ranges::none_of(places, [&](const IndexPlace& place) { return place.binder == binder; })) continue;
      stand_in.binders.push_back(binder);
      count *= names_.binders[binder].indices.size();
      if (count > kMostOfOneName) return false;
    }
    if (count_ + count > kMostImplied) return false;
    for (size_t i = 0; i < count; ++i) stand_in.names.push_back(member(indexed, places, stand_in.binders, i));
    add(std::move(stand_in));
    return true;
  }

  void find_places(const Name& indexed, size_t subscript, std::span<const uint32_t> open,
                   std::vector<IndexPlace>& places) const {
    const std::vector<std::string> items = items_of(indexed.subscripts[subscript]);
    for (size_t item = 0; item < items.size(); ++item) {
      for (size_t i = open.size(); i-- > 0;) {
        const Binder& binder = names_.binders[open[i]];
        if (!name(binder.variable).valid() || table_.text(name(binder.variable)) != items[item]) continue;
        if (!binder.indices.empty()) places.push_back({open[i], subscript, item});
        break;
      }
    }
  }

  NameId member(const Name& indexed, std::span<const IndexPlace> places, std::span<const uint32_t> binders,
                size_t position) {
    Name name = indexed;
    for (size_t b = binders.size(); b-- > 0;) {
      const std::vector<int>& indices = names_.binders[binders[b]].indices;
      const std::string number = std::to_string(indices[position % indices.size()]);
      position /= indices.size();
      for (const IndexPlace& place : places) {
        if (place.binder != binders[b]) continue;
        std::vector<std::string> items = items_of(name.subscripts[place.subscript]);
        items[place.item] = number;
        name.subscripts[place.subscript] = joined(items);
      }
    }
    return table_.intern(canonical_form(name));
  }

  void add(StandIn stand_in) {
    count_ += stand_in.names.size();
    names_.stand_ins.push_back(std::move(stand_in));
  }

  const ParsedBlock& block_;
  NameTable& table_;
  BlockNames& names_;
  OpenBinders open_;
  size_t count_ = 0;
};

}  // namespace

const BoundUse* BlockNames::bound_use(NodeId node) const {
  const auto found = std::ranges::lower_bound(bound, node, {}, &BoundUse::node);
  return found == bound.end() || found->node != node ? nullptr : &*found;
}

const StandIn* BlockNames::stand_in(NodeId node) const {
  const auto found = std::ranges::lower_bound(stand_ins, node, {}, &StandIn::node);
  return found == stand_ins.end() || found->node != node ? nullptr : &*found;
}

void read_bound_names(const ParsedBlock& block, NameTable& table, BlockNames& names) {
  names.binders = find_binders(block);
  const bool may_hold_some = !names.binders.empty() || std::ranges::any_of(block.tokens, [](const Token& token) {
    return token.kind == TokenKind::Prime;
  });
  if (may_hold_some) BoundNameReader(block, table, names).run();
}

}  // namespace texbrdf
