#include "analysis/suggestions.h"

namespace texbrdf {
namespace {

// Steps of comparing names, some nanoseconds each.
constexpr uint64_t kMaxSteps = 400'000;
constexpr size_t kMaxAnswers = 10'000;

}  // namespace

std::optional<std::string> NameSuggestions::nearest(const std::string& wanted, const SegmentSequence& segments,
                                                    const NameTable& names) {
  const std::lock_guard lock(mutex_);
  if (const auto known = answers_.find(wanted); known != answers_.end()) return known->second;
  if (!is_listed_) list_candidates(segments, names);
  if (answers_.size() >= kMaxAnswers) answers_.clear();
  uint64_t steps = kMaxSteps;
  return answers_[wanted] = candidates_.find(wanted, steps);
}

void NameSuggestions::list_candidates(const SegmentSequence& segments, const NameTable& names) {
  is_listed_ = true;
  segments.visit_from(0, [&](const Segment& segment, const Segment::Measure&) {
    if (!segment.block) return true;
    for (uint32_t i = 0; i < segment.block->definitions.size(); ++i) {
      const bool in_force = segment.block->definitions[i].in_force;
      if (in_force) candidates_.add(names.text(segment.block->analysed->defined(i)));
    }
    return true;
  });
  for (const ConventionEntry& entry : conventions()) {
    for (std::string_view spelling : entry.spellings) candidates_.add(spelling);
  }
}

}  // namespace texbrdf
