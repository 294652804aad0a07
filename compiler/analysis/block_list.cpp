#include "analysis/block_list.h"

#include <algorithm>
#include <unordered_map>

namespace texbrdf {
namespace {

class Lister {
 public:
  Lister(std::string_view document, const std::vector<PlacedBlock>& old, NameTable& table)
      : document_(document), old_(old), table_(table), extents_(scan_blocks(document)) {}

  BlockList run() {
    const size_t shorter = std::min(old_.size(), extents_.size());
    size_t prefix = 0;
    while (prefix < shorter && is_same(prefix, prefix)) ++prefix;
    size_t suffix = 0;
    while (suffix < shorter - prefix && is_same(old_.size() - 1 - suffix, extents_.size() - 1 - suffix)) ++suffix;

    list_.scanned = extents_.size();
    list_.blocks.reserve(extents_.size());
    for (size_t i = 0; i < prefix; ++i) take_over(i, i);
    add_changed(prefix, old_.size() - suffix, extents_.size() - suffix);
    for (size_t i = suffix; i > 0; --i) take_over(old_.size() - i, extents_.size() - i);
    return std::move(list_);
  }

 private:
  std::string_view text(size_t index) const {
    const Span whole = extents_[index].whole;
    return document_.substr(whole.begin, whole.size());
  }
  bool is_same(size_t old_index, size_t index) const {
    return old_[old_index].block->is_same(text(index), extents_[index]);
  }

  void take_over(size_t old_index, size_t index) {
    list_.blocks.push_back({extents_[index].whole.begin, old_[old_index].block, static_cast<uint32_t>(old_index)});
  }

  void add_changed(size_t first, size_t old_end, size_t end) {
    std::unordered_map<std::string_view, size_t> moved;
    for (size_t i = first; i < old_end; ++i) moved.emplace(old_[i].block->parsed.text, i);
    for (size_t i = first; i < end; ++i) {
      const auto found = moved.find(text(i));
      if (found != moved.end() && is_same(found->second, i)) {
        take_over(found->second, i);
      } else {
        add_new(i);
      }
    }
  }

  void add_new(size_t index) {
    auto block = std::make_shared<const AnalysedBlock>(analyse_block(text(index), extents_[index], table_));
    list_.blocks.push_back({extents_[index].whole.begin, std::move(block), UINT32_MAX});
    ++list_.parsed;
  }

  std::string_view document_;
  const std::vector<PlacedBlock>& old_;
  NameTable& table_;
  std::vector<BlockExtent> extents_;
  BlockList list_;
};

}  // namespace

BlockList list_blocks(std::string_view document, const std::vector<PlacedBlock>& old, NameTable& table) {
  return Lister(document, old, table).run();
}

}  // namespace texbrdf
