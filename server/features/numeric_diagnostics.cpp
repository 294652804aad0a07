#include "features/numeric_diagnostics.h"

#include <algorithm>
#include <utility>

namespace texbrdf::features {
namespace {

bool holds(const std::vector<NameId>& names, NameId name) {
  return std::ranges::find(names, name) != names.end();
}

/// A redefined convention is news where it is found to be another thing.
bool is_news(const Snapshot& snapshot, const Diagnostic& diagnostic, const NumericFindings* findings) {
  const NameId convention = redefined_convention(snapshot, diagnostic);
  return !convention.valid() || (findings != nullptr && !holds(findings->usual, convention));
}

/// What the root does not need is a hint at most.
std::vector<NameId> needs_of_root(const Snapshot& snapshot, std::string_view root) {
  const std::optional<DefinitionId> id = snapshot.find(root.empty() ? snapshot.root_name() : std::string(root));
  if (!id) return {};
  const NameId name = snapshot.definition(*id).name;
  return snapshot.needs_of({&name, 1});
}

void add_findings(const Snapshot& snapshot, const NumericFindings& findings, std::string_view root,
                  std::vector<Diagnostic>& diagnostics) {
  const std::vector<NameId> needed = needs_of_root(snapshot, root);
  for (const NumericFindings::Finding& finding : findings.findings) {
    const std::optional<DefinitionId> id = snapshot.find(finding.about);
    if (!id) continue;
    diagnostics.push_back(finding.diagnostic);
    diagnostics.back().where.block = snapshot.definition(*id).block;
    if (!holds(needed, finding.about)) diagnostics.back().severity = Severity::Hint;
  }
  std::ranges::stable_sort(diagnostics, {},
                           [](const Diagnostic& d) { return std::pair(d.where.block, d.where.span.begin); });
}

}  // namespace

std::vector<Diagnostic> diagnostics_with(const Snapshot& snapshot, const NumericFindings* findings,
                                         std::string_view root) {
  std::vector<Diagnostic> all = root.empty() ? snapshot.diagnostics() : snapshot.diagnostics(root);
  std::erase_if(all, [&](const Diagnostic& diagnostic) { return !is_news(snapshot, diagnostic, findings); });
  if (findings != nullptr && !findings->findings.empty()) add_findings(snapshot, *findings, root, all);
  return all;
}

std::vector<Diagnostic> all_diagnostics(const Snapshot& snapshot, std::string_view root) {
  const std::optional<NumericFindings> findings = find_numerically(snapshot, numeric_questions(snapshot, root));
  return diagnostics_with(snapshot, findings ? &*findings : nullptr, root);
}

}  // namespace texbrdf::features
