#include "analysis/working_blocks.h"

#include "source/internal_error.h"

namespace texbrdf {

size_t WorkingBlocks::place_of(BlockLabel label) const {
  if (next_ >= blocks_.size() || blocks_[next_].label != label) {
    const auto known = places_.find(label);
    if (known == places_.end()) return blocks_.size();
    next_ = known->second;
  }
  return next_++;
}

WorkingBlock* WorkingBlocks::find(BlockLabel label) {
  const size_t place = place_of(label);
  return place == blocks_.size() ? nullptr : &blocks_[place];
}

const WorkingBlock* WorkingBlocks::find(BlockLabel label) const {
  const size_t place = place_of(label);
  return place == blocks_.size() ? nullptr : &blocks_[place];
}

WorkingBlock& WorkingBlocks::open(BlockLabel label) {
  if (WorkingBlock* known = find(label)) return *known;
  const auto place = find_block(segments_, label);
  require(place.item != nullptr, "a block that is changed exists");
  const PlacedBlock& block = *place.item->block;
  add({block.label, block.extent, block.analysed, block.definitions});
  return blocks_.back();
}

const AnalysedBlock* WorkingBlocks::analysed(BlockLabel label) const {
  if (const WorkingBlock* block = find(label)) return block->analysed.get();
  const auto place = find_block(segments_, label);
  return place.item == nullptr ? nullptr : place.item->block->analysed.get();
}

}  // namespace texbrdf
