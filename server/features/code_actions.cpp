#include "features/code_actions.h"

#include <algorithm>
#include <span>

#include "features/define_name.h"

namespace texbrdf::features {
namespace {

CodeAction action_of(const Snapshot& snapshot, const Diagnostic& diagnostic, const Fix& fix) {
  CodeAction action{.title = fix.title, .edits = {}, .diagnostic = shown(snapshot, diagnostic)};
  for (const Edit& edit : fix.edits) action.edits.push_back({snapshot.absolute(edit.where), edit.replacement});
  action.is_preferred = diagnostic.fixes.size() == 1;
  return action;
}

bool touch(Span a, Span b) {
  return a.begin <= b.end && b.begin <= a.end;
}

/// Those that the range touches; only its blocks and prose, which comes last, are looked at.
std::vector<Diagnostic> diagnostics_at(const Snapshot& snapshot, Span range) {
  const std::span<const Diagnostic> all = snapshot.diagnostics();
  std::vector<Diagnostic> touched;
  const auto take = [&](std::span<const Diagnostic> some) {
    for (const Diagnostic& diagnostic : some) {
      if (touch(snapshot.absolute(diagnostic.where), range)) touched.push_back(diagnostic);
    }
  };
  const auto first_of = [all](BlockId block) {
    const auto block_of = [](const Diagnostic& diagnostic) { return diagnostic.where.block; };
    return std::ranges::lower_bound(all, block, {}, block_of);
  };
  if (const auto last = snapshot.block_at(range.end)) {
    const auto first = snapshot.block_at(std::max(range.begin, 1U) - 1);
    take({first_of(first.value_or(BlockId{0})), first_of(BlockId{last->value + 1})});
  }
  take({first_of(kProse), all.end()});
  return touched;
}

}  // namespace

std::vector<CodeAction> code_actions(const Snapshot& snapshot, Span range) {
  std::vector<CodeAction> actions;
  for (const Diagnostic& diagnostic : diagnostics_at(snapshot, range)) {
    for (const Fix& fix : diagnostic.fixes) actions.push_back(action_of(snapshot, diagnostic, fix));
    if (auto missing = define_missing_name(snapshot, diagnostic)) {
      actions.push_back(
          {std::move(missing->title), {std::move(missing->edit)}, shown(snapshot, diagnostic), /*is_preferred=*/false});
    }
  }
  return actions;
}

}  // namespace texbrdf::features
