#include "analysis/working_blocks.h"

#include <algorithm>
#include <cmath>

#include "source/internal_error.h"

namespace texbrdf {

void WorkingBlocks::add(WorkingBlock block) {
  const bool is_in_order = in_order_ == blocks_.size() && (blocks_.empty() || blocks_.back().label < block.label);
  if (is_in_order) {
    ++in_order_;
  } else {
    places_[block.label] = blocks_.size();
  }
  blocks_.push_back(std::move(block));
}

size_t WorkingBlocks::place_of(BlockLabel label) const {
  if (next_ < blocks_.size() && blocks_[next_].label == label) return next_++;
  size_t place = place_in_order(label);
  if (place == blocks_.size()) {
    const auto known = places_.find(label);
    if (known == places_.end()) return blocks_.size();
    place = known->second;
  }
  next_ = place + 1;
  return place;
}

size_t WorkingBlocks::place_in_order(BlockLabel label) const {
  if (in_order_ == 0) return blocks_.size();
  const BlockLabel first = blocks_.front().label;
  const BlockLabel last = blocks_[in_order_ - 1].label;
  if (label < first || label > last) return blocks_.size();
  // The labels of a new document are evenly spread: the guess is right.
  const double part = static_cast<double>(label - first) / std::max(1.0, static_cast<double>(last - first));
  const auto guess = static_cast<size_t>(std::lround(part * static_cast<double>(in_order_ - 1)));
  if (blocks_[guess].label == label) return guess;
  const auto end = blocks_.begin() + static_cast<std::ptrdiff_t>(in_order_);
  const auto found = std::ranges::lower_bound(blocks_.begin(), end, label, {}, &WorkingBlock::label);
  return found->label == label ? static_cast<size_t>(found - blocks_.begin()) : blocks_.size();
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
