#include "analysis/rescan.h"

#include <optional>

namespace texbrdf {
namespace {

constexpr BlockLabel kLastLabel = UINT64_MAX;
constexpr uint64_t kFirstWindow = 4096;
constexpr uint64_t kWindowGrowth = 4;

Segment prose_segment(const DocumentPart& part, std::string_view text) {
  Segment segment{.size = part.size, .reach = part.reach, .block = nullptr, .directives = nullptr};
  if (part.directives.empty()) return segment;
  auto directives = std::make_shared<std::vector<Directive>>();
  for (Span span : part.directives) {
    if (auto directive = read_directive(text.substr(part.begin + span.begin, span.size()), span)) {
      directives->push_back(std::move(*directive));
    }
  }
  segment.directives = std::move(directives);
  return segment;
}

Segment block_segment(const DocumentPart& part, BlockLabel label) {
  auto block = std::make_shared<PlacedBlock>();
  block->label = label;
  block->extent = *part.block;
  block->extent.whole = {0, part.size};
  return {.size = part.size, .reach = part.reach, .block = std::move(block), .directives = nullptr};
}

/// Labels between two others, evenly spread; empty where they do not fit.
std::vector<BlockLabel> labels_between(BlockLabel low, BlockLabel high, size_t count) {
  const BlockLabel step = (high - low) / (count + 1);
  std::vector<BlockLabel> labels;
  if (step == 0) return labels;
  for (size_t i = 1; i <= count; ++i) labels.push_back(low + step * i);
  return labels;
}

class Rescanner {
 public:
  Rescanner(const SegmentSequence& old, const SourceText& text, const TextEdit& edit)
      : old_(old), text_(text), edit_(edit) {
    auto first = old.find([&](const Segment::Measure& sum) { return sum.reach >= edit.begin; });
    if (first.item == nullptr && !old.empty()) first = old.at(old.size() - 1);
    first_ = first.index;
    begin_ = first.before.bytes;
    low_label_ = first.before.last_label;
  }

  Rescan run() {
    for (uint64_t window = first_window(); !scan(window); window *= kWindowGrowth) {
    }
    return assemble();
  }

 private:
  uint64_t first_window() const { return edit_.begin - begin_ + edit_.new_size + kFirstWindow; }

  /// False where more of the text has to be seen.
  bool scan(uint64_t window) {
    const bool is_whole = window >= text_.size() - begin_;
    window_ = text_.slice({begin_, is_whole ? text_.size() : begin_ + static_cast<uint32_t>(window)});
    parts_.clear();
    BlockScanner scanner(window_, is_whole);
    uint32_t at = begin_;
    while (std::optional<DocumentPart> part = scanner.next()) {
      if (part->is_epilogue) part->size = text_.size() - at;
      at += part->size;
      parts_.push_back(std::move(*part));
      if (agrees_at(at)) return true;
    }
    behind_ = old_.size();
    return is_whole;
  }

  bool agrees_at(uint32_t at) {
    if (at == text_.size()) {
      behind_ = old_.size();
      return true;
    }
    if (at < edit_.begin + edit_.new_size) return false;
    const uint32_t old_at = at - edit_.new_size + edit_.old_size;
    const auto next = old_.find([old_at](const Segment::Measure& sum) { return sum.bytes > old_at; });
    behind_ = next.index;
    return next.before.bytes == old_at;
  }

  size_t block_count() const {
    return static_cast<size_t>(
        std::ranges::count_if(parts_, [](const DocumentPart& p) { return p.block.has_value(); }));
  }

  Rescan assemble() {
    Rescan result;
    uint32_t index = first_;
    old_.visit_from(first_, [&](const Segment& segment, const Segment::Measure&) {
      if (index++ == behind_) return false;
      if (segment.block) result.removed.push_back(segment.block);
      return true;
    });
    const std::vector<BlockLabel> labels = choose_labels(result.removed);
    if (labels.size() < block_count()) {
      result.segments = scan_document(text_);
      result.relabelled = true;
      return result;
    }
    result.segments = old_.with(first_, behind_ - first_, new_segments(labels, result.added));
    return result;
  }

  std::vector<BlockLabel> choose_labels(const std::vector<std::shared_ptr<const PlacedBlock>>& removed) const {
    const size_t count = block_count();
    std::vector<BlockLabel> labels;
    const size_t kept = std::min(count, removed.size());
    for (size_t i = 0; i < kept; ++i) labels.push_back(removed[i]->label);
    if (kept == count) return labels;
    const BlockLabel low = labels.empty() ? low_label_ : labels.back();
    const std::vector<BlockLabel> fresh = labels_between(low, next_label(), count - kept);
    labels.insert(labels.end(), fresh.begin(), fresh.end());
    return labels;
  }

  BlockLabel next_label() const {
    const uint32_t blocks = old_.at(behind_).before.blocks;
    const auto next = old_.find([blocks](const Segment::Measure& sum) { return sum.blocks > blocks; });
    return next.item == nullptr ? kLastLabel : next.item->block->label;
  }

  std::vector<Segment> new_segments(const std::vector<BlockLabel>& labels,
                                    std::vector<std::shared_ptr<const PlacedBlock>>& added) const {
    std::vector<Segment> segments;
    for (const DocumentPart& part : parts_) {
      if (part.block) {
        segments.push_back(block_segment(part, labels[added.size()]));
        added.push_back(segments.back().block);
      } else {
        segments.push_back(prose_segment(part, window_));
      }
    }
    return segments;
  }

  const SegmentSequence& old_;
  const SourceText& text_;
  const TextEdit edit_;
  uint32_t first_ = 0;        // the first segment that is scanned again
  uint32_t begin_ = 0;        // its first byte
  BlockLabel low_label_ = 0;  // of the block before it
  uint32_t behind_ = 0;       // the first segment behind it that stays
  std::string window_;
  std::vector<DocumentPart> parts_;
};

}  // namespace

SegmentSequence scan_document(const SourceText& text) {
  const std::string bytes = text.bytes();
  const std::vector<DocumentPart> parts = scan_parts(bytes);
  const auto blocks = std::ranges::count_if(parts, [](const DocumentPart& p) { return p.block.has_value(); });
  const std::vector<BlockLabel> labels = labels_between(0, kLastLabel, static_cast<size_t>(blocks));
  std::vector<Segment> segments;
  segments.reserve(parts.size());
  size_t block = 0;
  for (const DocumentPart& part : parts) {
    segments.push_back(part.block ? block_segment(part, labels[block++]) : prose_segment(part, bytes));
  }
  return SegmentSequence(segments);
}

Rescan rescan(const SegmentSequence& segments, const SourceText& text, const TextEdit& edit) {
  return Rescanner(segments, text, edit).run();
}

}  // namespace texbrdf
