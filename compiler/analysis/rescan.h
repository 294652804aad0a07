#pragma once

#include <vector>

#include "analysis/project_text.h"
#include "analysis/segment.h"

namespace texbrdf {

/// What an edit makes of the segments of a document.
struct Rescan {
  SegmentSequence segments;
  std::vector<std::shared_ptr<const PlacedBlock>> removed;
  std::vector<std::shared_ptr<const PlacedBlock>> added;  ///< not read yet; one in the place of another has its label
  bool macros = false;                                    ///< some are defined in what was removed or added
  /// No label was left between two blocks: all need new ones, and nothing else is told.
  bool relabelled = false;
};

/// In a file, the bytes [begin, begin + old_size) were replaced by new_size others.
struct TextEdit {
  FileId file;
  uint32_t begin = 0;
  uint32_t old_size = 0;
  uint32_t new_size = 0;
};

/// Each file is scanned on its own; between two stands a segment of one byte.
SegmentSequence scan_files(const ProjectText& text);

/// Scans from the last segment that nothing of the edit decides until old and new segments begin at the same byte.
/// `text` is that after the edit.
Rescan rescan(const SegmentSequence& segments, const ProjectText& text, const TextEdit& edit);

/// An empty file is put in, not as the first, or taken out. `text` is that without it.
SegmentSequence with_empty_file(const SegmentSequence& segments, const ProjectText& text, FileId file);
SegmentSequence without_empty_file(const SegmentSequence& segments, const ProjectText& text, FileId file);

}  // namespace texbrdf
