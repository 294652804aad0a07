#include "features/code_actions.h"

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

}  // namespace

std::vector<CodeAction> code_actions(const Snapshot& snapshot, Span range) {
  std::vector<CodeAction> actions;
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    if (!touch(snapshot.absolute(diagnostic.where), range)) continue;
    for (const Fix& fix : diagnostic.fixes) actions.push_back(action_of(snapshot, diagnostic, fix));
    if (auto missing = define_missing_name(snapshot, diagnostic)) {
      actions.push_back(
          {std::move(missing->title), {std::move(missing->edit)}, shown(snapshot, diagnostic), /*is_preferred=*/false});
    }
  }
  return actions;
}

}  // namespace texbrdf::features
