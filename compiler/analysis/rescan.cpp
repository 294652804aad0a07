#include "analysis/rescan.h"

#include <algorithm>
#include <optional>

#include "source/shared_pool.h"

namespace texbrdf {
namespace {

constexpr BlockLabel kLastLabel = UINT64_MAX;
constexpr uint64_t kFirstWindow = 4096;
constexpr uint64_t kWindowGrowth = 4;

/// Stands between two files.
const Segment kSeparator{.size = 1, .reach = 1, .block = nullptr, .remarks = nullptr, .macros = nullptr};

std::shared_ptr<const std::vector<MacroDefinition>> macros_in(const DocumentPart& part) {
  return part.macros.empty() ? nullptr : std::make_shared<const std::vector<MacroDefinition>>(part.macros);
}

Include read_include(const IncludeCommand& command, std::string_view part) {
  const auto text = [part](Span span) { return std::string(part.substr(span.begin, span.size())); };
  return {{command.kind, text(command.folder), text(command.path)}, command.span};
}

std::shared_ptr<const ProseRemarks> read_remarks(const DocumentPart& part, std::string_view text) {
  ProseRemarks remarks;
  for (Span span : part.directives) {
    if (auto directive = read_directive(text.substr(span.begin, span.size()), span)) {
      remarks.directives.push_back(std::move(*directive));
    }
  }
  for (const IncludeCommand& command : part.includes) remarks.includes.push_back(read_include(command, text));
  if (remarks.directives.empty() && remarks.includes.empty()) return nullptr;
  return std::make_shared<const ProseRemarks>(std::move(remarks));
}

Segment prose_segment(const DocumentPart& part, std::string_view text) {
  return {.size = part.size,
          .reach = part.reach,
          .block = nullptr,
          .remarks = read_remarks(part, text.substr(part.begin, part.size)),
          .macros = macros_in(part)};
}

Segment block_segment(const DocumentPart& part, BlockLabel label, SharedPool<PlacedBlock>& blocks) {
  std::shared_ptr<PlacedBlock> block = blocks.make();
  block->label = label;
  block->extent = *part.block;
  block->extent.whole = {0, part.size};
  return {
      .size = part.size, .reach = part.reach, .block = std::move(block), .remarks = nullptr, .macros = macros_in(part)};
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
  Rescanner(const SegmentSequence& old, const ProjectText& text, const TextEdit& edit)
      : old_(old),
        text_(text.file(edit.file)),
        language_(text.language(edit.file)),
        edit_(edit),
        origin_(text.begin(edit.file)) {
    const auto first_of_file = segment_at(0);
    auto first = old.find([&](const Segment::Measure& sum) { return sum.reach >= origin_ + edit.begin; });
    if (first.index < first_of_file.index) first = first_of_file;
    first_ = first.index;
    begin_ = first.before.bytes - origin_;
    low_label_ = first.before.last_label;
    end_of_file_ = segment_at(text_.size() - edit.new_size + edit.old_size).index;
  }

  Rescan run() {
    for (uint64_t window = first_window(); !scan(window); window *= kWindowGrowth) {
    }
    return assemble();
  }

 private:
  /// The old segment that holds the byte of the file, before the edit.
  SegmentSequence::Place segment_at(uint32_t old_byte) const {
    const uint32_t at = origin_ + old_byte;
    return old_.find([at](const Segment::Measure& sum) { return sum.bytes > at; });
  }

  uint64_t first_window() const { return edit_.begin - begin_ + edit_.new_size + kFirstWindow; }

  bool starts_line() const {
    if (begin_ == 0) return true;
    const std::string before = text_.slice({begin_ - 1, begin_});
    return before == "\n" || before == "\r";
  }

  /// False where more of the text has to be seen.
  bool scan(uint64_t window) {
    const bool is_whole = window >= text_.size() - begin_;
    window_ = text_.slice({begin_, is_whole ? text_.size() : begin_ + static_cast<uint32_t>(window)});
    parts_.clear();
    BlockScanner scanner(window_, is_whole, language_, starts_line());
    uint32_t at = begin_;
    while (std::optional<DocumentPart> part = scanner.next()) {
      if (part->is_epilogue) part->size = part->reach = text_.size() - at;
      at += part->size;
      parts_.push_back(std::move(*part));
      if (agrees_at(at)) return true;
    }
    behind_ = end_of_file_;
    return is_whole;
  }

  bool agrees_at(uint32_t at) {
    if (at == text_.size()) {
      behind_ = end_of_file_;
      return true;
    }
    const uint32_t behind_edit = edit_.begin + edit_.new_size;
    // In Markdown the byte before a part is to be an old one: it tells whether the part starts a line.
    const bool is_behind = language_ == TextLanguage::Markdown ? at > behind_edit : at >= behind_edit;
    if (!is_behind) return false;
    const uint32_t old_at = at - edit_.new_size + edit_.old_size;
    const auto next = segment_at(old_at);
    behind_ = next.index;
    return next.before.bytes == origin_ + old_at;
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
      if (segment.macros) result.macros = true;
      return true;
    });
    if (std::ranges::any_of(parts_, [](const DocumentPart& part) { return !part.macros.empty(); }))
      result.macros = true;
    const std::vector<BlockLabel> labels = choose_labels(result.removed);
    if (labels.size() < block_count()) {
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
    if (behind_ == old_.size()) return kLastLabel;
    const uint32_t blocks = old_.at(behind_).before.blocks;
    const auto next = old_.find([blocks](const Segment::Measure& sum) { return sum.blocks > blocks; });
    return next.item == nullptr ? kLastLabel : next.item->block->label;
  }

  std::vector<Segment> new_segments(const std::vector<BlockLabel>& labels,
                                    std::vector<std::shared_ptr<const PlacedBlock>>& added) const {
    std::vector<Segment> segments;
    SharedPool<PlacedBlock> blocks(labels.size());
    for (const DocumentPart& part : parts_) {
      if (part.block) {
        segments.push_back(block_segment(part, labels[added.size()], blocks));
        added.push_back(segments.back().block);
      } else {
        segments.push_back(prose_segment(part, window_));
      }
    }
    return segments;
  }

  const SegmentSequence& old_;
  const SourceText& text_;
  const TextLanguage language_;
  const TextEdit edit_;
  const uint32_t origin_;     // of the file among all
  uint32_t first_ = 0;        // the first segment that is scanned again
  uint32_t begin_ = 0;        // its first byte, in the file
  BlockLabel low_label_ = 0;  // of the block before it
  uint32_t end_of_file_ = 0;  // the first old segment behind the file
  uint32_t behind_ = 0;       // the first segment behind it that stays
  std::string window_;
  std::vector<DocumentPart> parts_;
};

}  // namespace

SegmentSequence scan_files(const ProjectText& text) {
  std::vector<std::string> bytes;
  std::vector<std::vector<DocumentPart>> parts;
  size_t blocks = 0;
  for (uint32_t file = 0; file < text.file_count(); ++file) {
    bytes.push_back(text.file({file}).bytes());
    parts.push_back(scan_parts(bytes.back(), text.language({file})));
    blocks += static_cast<size_t>(
        std::ranges::count_if(parts.back(), [](const DocumentPart& part) { return part.block.has_value(); }));
  }
  const std::vector<BlockLabel> labels = labels_between(0, kLastLabel, blocks);
  SharedPool<PlacedBlock> placed(blocks);
  std::vector<Segment> segments;
  size_t block = 0;
  for (size_t file = 0; file < parts.size(); ++file) {
    if (file > 0) segments.push_back(kSeparator);
    segments.reserve(segments.size() + parts[file].size());
    for (const DocumentPart& part : parts[file]) {
      segments.push_back(part.block ? block_segment(part, labels[block++], placed) : prose_segment(part, bytes[file]));
    }
  }
  return SegmentSequence(std::move(segments));
}

Rescan rescan(const SegmentSequence& segments, const ProjectText& text, const TextEdit& edit) {
  return Rescanner(segments, text, edit).run();
}

SegmentSequence with_empty_file(const SegmentSequence& segments, const ProjectText& text, FileId file) {
  const uint32_t end_before = text.span({file.value - 1}).end;
  const auto behind = segments.find([end_before](const Segment::Measure& sum) { return sum.bytes > end_before; });
  return segments.with(behind.index, 0, std::span(&kSeparator, 1));
}

SegmentSequence without_empty_file(const SegmentSequence& segments, const ProjectText& text, FileId file) {
  const uint32_t end_before = text.span({file.value - 1}).end;
  const auto separator = segments.find([end_before](const Segment::Measure& sum) { return sum.bytes > end_before; });
  return segments.with(separator.index, 1, {});
}

}  // namespace texbrdf
