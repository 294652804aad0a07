#include "syntax/macro_expansion.h"

#include <algorithm>

namespace texbrdf {
namespace {

/// A stretch of so many runs, or more, is told by the use around it.
constexpr size_t kMaxRunsOfStretch = 64;

}  // namespace

size_t MacroExpansion::run_of(uint32_t expanded) const {
  const auto behind = std::ranges::upper_bound(runs_, expanded, {}, &Run::begin);
  return static_cast<size_t>(behind - runs_.begin()) - 1;
}

uint32_t MacroExpansion::end_of(size_t run) const {
  return run + 1 < runs_.size() ? runs_[run + 1].begin : static_cast<uint32_t>(text_.size());
}

Span MacroExpansion::in_source(Span expanded) const {
  const size_t first = run_of(expanded.begin);
  const size_t last = expanded.empty() ? first : run_of(expanded.end - 1);
  const auto source_of = [&](size_t run) -> Span {
    const Run& r = runs_[run];
    if (!r.is_written) return r.source;
    const uint32_t begin = std::max(expanded.begin, r.begin) - r.begin;
    const uint32_t end = std::min(expanded.end, end_of(run)) - r.begin;
    return {r.source.begin + begin, r.source.begin + std::max(begin, end)};
  };
  if (expanded.empty() && !runs_[first].is_written) return {runs_[first].source.begin, runs_[first].source.begin};
  if (first == last) return source_of(first);
  const uint32_t top = runs_[first].top;
  const uint32_t last_top = runs_[last].top;
  if (top == kNoUse || top != last_top || last - first > kMaxRunsOfStretch) {
    const Span begin = top == kNoUse ? source_of(first) : tops_[top];
    const Span end = last_top == kNoUse ? source_of(last) : tops_[last_top];
    return {begin.begin, std::max(begin.begin, end.end)};
  }
  Span hull = source_of(first);
  for (size_t run = first + 1; run <= last; ++run) {
    const Span part = source_of(run);
    hull = {std::min(hull.begin, part.begin), std::max(hull.end, part.end)};
  }
  return hull;
}

bool MacroExpansion::is_one_copy(Span expanded) const {
  const size_t run = run_of(expanded.begin);
  return runs_[run].is_written && expanded.end <= end_of(run);
}

bool MacroExpansion::is_written(Span expanded) const {
  if (is_one_copy(expanded)) return true;
  // Between a copy and what a macro made, something can still be put in.
  return expanded.empty() && expanded.begin > 0 && is_one_copy({expanded.begin - 1, expanded.begin});
}

bool MacroExpansion::is_replaceable(Span expanded) const {
  return is_written(expanded) && !runs_[run_of(expanded.begin)].is_bare;
}

std::optional<uint32_t> MacroExpansion::from_source(uint32_t offset) const {
  std::optional<uint32_t> touched;
  for (size_t run = 0; run < runs_.size(); ++run) {
    const Run& r = runs_[run];
    if (!r.is_written || offset < r.source.begin) continue;
    const uint32_t into = offset - r.source.begin;
    const uint32_t size = end_of(run) - r.begin;
    if (into < size || (run + 1 == runs_.size() && into == size)) return r.begin + into;
    if (into == size && !touched) touched = r.begin + into;
  }
  return touched;
}

const MacroUse* MacroExpansion::maker_of(Span expanded) const {
  if (is_one_copy(expanded)) return nullptr;
  const Span source = in_source(expanded);
  const auto found = std::ranges::lower_bound(uses_, source, {}, &MacroUse::whole);
  return found != uses_.end() && found->whole == source ? &*found : nullptr;
}

const MacroUse* MacroExpansion::use_at(uint32_t source_offset) const {
  const MacroUse* touched = nullptr;
  for (const MacroUse& use : uses_) {
    if (!use.command.touches(source_offset)) continue;
    touched = &use;
    if (source_offset < use.command.end) return touched;
  }
  return touched;
}

bool MacroExpansion::stands_for_same(const MacroExpansion& other) const {
  return text_ == other.text_ && runs_ == other.runs_ && uses_ == other.uses_ && problems_ == other.problems_ &&
         tops_ == other.tops_ && has_definitions_ == other.has_definitions_;
}

const MacroProblem* MacroExpansion::problem_at(uint32_t expanded) const {
  const auto found = std::ranges::lower_bound(problems_, expanded, {}, &MacroProblem::at);
  return found != problems_.end() && found->at == expanded ? &*found : nullptr;
}

}  // namespace texbrdf
