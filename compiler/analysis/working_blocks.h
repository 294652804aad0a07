#pragma once

#include <unordered_map>
#include <vector>

#include "analysis/segment.h"

namespace texbrdf {

/// A block whose place in the document is being changed.
struct WorkingBlock {
  BlockLabel label = 0;
  BlockExtent extent;
  std::shared_ptr<const AnalysedBlock> analysed;
  std::vector<PlacedDefinition> definitions;
};

/// The blocks of a document during an update: those that change are copied when they are first asked for.
class WorkingBlocks {
 public:
  explicit WorkingBlocks(const SegmentSequence& segments) : segments_(segments) {}

  void reserve(size_t blocks) { blocks_.reserve(blocks); }
  void add(WorkingBlock block);

  /// To change. Precondition: the block exists. Valid until the next call.
  WorkingBlock& open(BlockLabel label);
  /// To change; nullptr where it was neither added nor opened.
  WorkingBlock* find(BlockLabel label);
  /// To read; nullptr where there is no such block, or nobody has read it.
  const AnalysedBlock* analysed(BlockLabel label) const;
  const WorkingBlock* find(BlockLabel label) const;

  const std::vector<WorkingBlock>& all() const { return blocks_; }
  std::vector<WorkingBlock>& all() { return blocks_; }

 private:
  size_t place_of(BlockLabel label) const;
  size_t place_in_order(BlockLabel label) const;

  const SegmentSequence& segments_;
  std::vector<WorkingBlock> blocks_;
  size_t in_order_ = 0;                            // so many from the first on have rising labels
  std::unordered_map<BlockLabel, size_t> places_;  // of the others
  mutable size_t next_ = 0;                        // most blocks are asked for one after the other
};

}  // namespace texbrdf
