#include "features/folding_ranges.h"

#include <optional>
#include <string_view>

namespace texbrdf::features {
namespace {

/// Relative to the block.
std::optional<Fold> fold_of(const ParsedBlock& block) {
  const BlockExtent& extent = block.source_extent();
  const std::string_view text = block.source();
  Fold fold{{extent.begin.end, extent.end.begin}, !extent.end.empty()};
  if (!fold.has_end) {
    const std::size_t last = text.substr(fold.inside.begin, fold.inside.size()).find_last_not_of(" \t\r\n");
    fold.inside.end = fold.inside.begin + static_cast<uint32_t>(last + 1);  // 0 where there is nothing
  }
  if (text.substr(fold.inside.begin, fold.inside.size()).find_first_of("\r\n") == std::string_view::npos)
    return std::nullopt;
  return fold;
}

}  // namespace

std::vector<Fold> folding_ranges(const Snapshot& snapshot) {
  std::vector<Fold> folds;
  for (const Block& block : snapshot.blocks()) {
    std::optional<Fold> fold = fold_of(*block.parsed);
    if (!fold) continue;
    fold->inside.begin += block.offset;
    fold->inside.end += block.offset;
    folds.push_back(*fold);
  }
  return folds;
}

}  // namespace texbrdf::features
