#include "lsp/block_splice.h"

#include <algorithm>

namespace texbrdf::lsp {
namespace {

uint32_t block_count(const Snapshot& snapshot) {
  return static_cast<uint32_t>(snapshot.blocks().size());
}

uint32_t begin_of(const Snapshot& snapshot, uint32_t block) {
  return snapshot.absolute(BlockId{block}, {}).begin;
}

uint32_t distance_to_end(const Snapshot& snapshot, uint32_t block) {
  return snapshot.text().size() - begin_of(snapshot, block);
}

bool share_parse(const Snapshot& before, uint32_t block_before, const Snapshot& after, uint32_t block_after) {
  return &before.parsed(BlockId{block_before}) == &after.parsed(BlockId{block_after});
}

/// How many blocks begin before the offset.
uint32_t blocks_before(const Snapshot& snapshot, uint32_t offset) {
  if (offset == 0) return 0;
  const std::optional<BlockId> last = snapshot.block_at(offset - 1);
  return last ? last->value + 1 : 0;
}

/// A block that begins in the same place behind the same text is one at which both scans were in the same state; so
/// all blocks before the last such block are the same.
uint32_t same_at_front(const Snapshot& before, const Snapshot& after, uint32_t kept) {
  uint32_t count = std::min(blocks_before(before, kept), blocks_before(after, kept));
  const auto is_same = [&](uint32_t block) {
    return begin_of(before, block) == begin_of(after, block) && share_parse(before, block, after, block);
  };
  while (count > 0 && !is_same(count - 1)) --count;
  return count;
}

}  // namespace

BlockSplice find_splice(const Snapshot& before, const Snapshot& after, const EditedRegion& edited) {
  const uint32_t size_before = before.text().size();
  const uint32_t size_after = after.text().size();
  const uint32_t kept_back = std::min({edited.kept_back, size_before, size_after});
  const uint32_t first = same_at_front(before, after, std::min({edited.kept_front, size_before, size_after}));

  // Behind the edits, where the scans meet again all that follows is the same.
  BlockSplice splice{first, std::max(first, blocks_before(before, size_before - kept_back)),
                     std::max(first, blocks_before(after, size_after - kept_back))};
  while (splice.before_end < block_count(before) && splice.after_end < block_count(after)) {
    const uint32_t rest_before = distance_to_end(before, splice.before_end);
    const uint32_t rest_after = distance_to_end(after, splice.after_end);
    if (rest_before == rest_after && share_parse(before, splice.before_end, after, splice.after_end)) return splice;
    if (rest_before >= rest_after) ++splice.before_end;
    if (rest_after >= rest_before) ++splice.after_end;
  }
  return {first, block_count(before), block_count(after)};
}

}  // namespace texbrdf::lsp
