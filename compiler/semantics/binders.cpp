#include "semantics/binders.h"

#include <algorithm>
#include <charconv>
#include <numeric>

namespace texbrdf {
namespace {

/// Terms that may be written out, and names that are looked up where the document says how many there are.
constexpr int kMostTerms = 64;
constexpr int kMostOpenTerms = 32;

std::optional<int> whole_number(const ParsedBlock& block, NodeId id) {
  const SyntaxTree& tree = block.tree;
  bool is_negative = false;
  while (tree.node(id).kind == NodeKind::Group || tree.node(id).kind == NodeKind::Prefix) {
    const bool is_minus = block.tokens[tree.node(id).token].kind == TokenKind::Minus;
    if (tree.node(id).kind == NodeKind::Prefix && is_minus) is_negative = !is_negative;
    id = tree.child(id, 0);
  }
  if (tree.node(id).kind != NodeKind::Number) return std::nullopt;
  const std::string_view text = block.node_text(id);
  constexpr size_t kMostDigits = 6;
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.size() > kMostDigits || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return is_negative ? -number : number;
}

void read_range(const ParsedBlock& block, Binder& binder) {
  const std::optional<int> first = whole_number(block, block.tree.child(binder.range, 0));
  if (!first) return;
  const std::optional<int> last = whole_number(block, block.tree.child(binder.range, 1));
  binder.is_open = !last;
  const int count = last ? *last - *first + 1 : kMostOpenTerms;
  if (count <= 0 || count > kMostTerms) return;
  binder.indices.resize(static_cast<size_t>(count));
  std::iota(binder.indices.begin(), binder.indices.end(), *first);
}

void read_set(const ParsedBlock& block, Binder& binder) {
  for (const NodeId element : block.tree.children(binder.range)) {
    const std::optional<int> index = whole_number(block, element);
    if (index) binder.indices.push_back(*index);
  }
  const size_t count = block.tree.node(binder.range).child_count;
  if (binder.indices.size() != count || count > kMostTerms) binder.indices.clear();
}

Binder binder(NodeId node, NodeId variable, NodeId range, NodeId body) {
  Binder made;
  made.node = node;
  made.variable = variable;
  made.range = range;
  made.body = body;
  return made;
}

/// By node, the first of its tree: an exponent may stand before its base.
std::vector<uint32_t> first_nodes(const SyntaxTree& tree) {
  std::vector<uint32_t> first(tree.size());
  for (uint32_t i = 0; i < tree.size(); ++i) {
    first[i] = i;
    for (const NodeId child : tree.children(NodeId{i})) first[i] = std::min(first[i], first[child.value]);
  }
  return first;
}

}  // namespace

std::vector<Binder> find_binders(const ParsedBlock& block) {
  const SyntaxTree& tree = block.tree;
  std::vector<Binder> found;
  for (uint32_t i = 0; i < tree.size(); ++i) {
    const NodeId id{i};
    switch (tree.node(id).kind) {
      case NodeKind::BigOperator:
        found.push_back(binder(id, tree.child(id, 0), tree.child(id, 1), tree.child(id, 2)));
        if (tree.node(tree.child(id, 1)).kind == NodeKind::Range) read_range(block, found.back());
        if (tree.node(tree.child(id, 1)).kind == NodeKind::Set) read_set(block, found.back());
        break;
      case NodeKind::Integral:
        found.push_back(binder(id, tree.child(id, 2), tree.child(id, 0), tree.child(id, 1)));
        found.back().is_over_directions = tree.node(found.back().range).kind == NodeKind::Domain;
        break;
      case NodeKind::Derivative:
        found.push_back(binder(id, tree.child(id, 1), {}, tree.child(id, 0)));
        break;
      default:
        break;
    }
  }
  if (found.empty()) return found;
  const std::vector<uint32_t> first = first_nodes(tree);
  for (Binder& binder : found) binder.first_node = first[binder.body.value];
  return found;
}

OpenBinders::OpenBinders(std::span<const Binder> binders) : binders_(binders), by_begin_(binders.size()) {
  std::iota(by_begin_.begin(), by_begin_.end(), 0);
  std::ranges::sort(by_begin_, [&](uint32_t a, uint32_t b) {
    return binders[a].first_node != binders[b].first_node ? binders[a].first_node < binders[b].first_node : a > b;
  });
}

void OpenBinders::advance_to(uint32_t node) {
  while (!open_.empty() && binders_[open_.back()].body.value < node) open_.pop_back();
  for (; next_ < by_begin_.size() && binders_[by_begin_[next_]].first_node <= node; ++next_) {
    if (binders_[by_begin_[next_]].body.value >= node) open_.push_back(by_begin_[next_]);
  }
}

std::optional<Directions> directions_of(const ParsedBlock& block, NodeId domain) {
  std::string_view text = block.node_text(domain);
  while (text.starts_with('{') && text.ends_with('}')) text = text.substr(1, text.size() - 2);
  const auto holds = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  if (text == "4\\pi" || holds("S^2") || holds("{S}") || holds("\\mathbb S") || text == "S") return Directions::Sphere;
  if (text == "2\\pi" || holds("\\Omega") || holds("H")) return Directions::Hemisphere;
  return std::nullopt;
}

}  // namespace texbrdf
