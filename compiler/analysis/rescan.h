#pragma once

#include <vector>

#include "analysis/segment.h"
#include "source/source_text.h"

namespace texbrdf {

/// What an edit makes of the segments of a document.
struct Rescan {
  SegmentSequence segments;
  std::vector<std::shared_ptr<const PlacedBlock>> removed;
  std::vector<std::shared_ptr<const PlacedBlock>> added;  ///< not read yet; one in the place of another has its label
  /// No label was left between two blocks: all have new ones, and `removed` and `added` say nothing.
  bool relabelled = false;
};

/// The bytes [begin, begin + old_size) were replaced by new_size others.
struct TextEdit {
  uint32_t begin = 0;
  uint32_t old_size = 0;
  uint32_t new_size = 0;
};

SegmentSequence scan_document(const SourceText& text);

/// Scans from the last segment that nothing of the edit decides until old and new segments begin at the same byte.
/// `text` is that after the edit.
Rescan rescan(const SegmentSequence& segments, const SourceText& text, const TextEdit& edit);

}  // namespace texbrdf
