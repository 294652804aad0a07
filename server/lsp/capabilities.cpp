#include "lsp/capabilities.h"

#include "lsp/code_actions.h"
#include "lsp/completion.h"
#include "lsp/semantic_tokens.h"
#include "lsp/signature_help.h"

namespace texbrdf::lsp {

void write_provider_options(JsonWriter& out, Feature feature, const InitializeParams& client) {
  switch (feature) {
    case Feature::Diagnostics:
      out.member("identifier", "texbrdf");
      out.member("interFileDependencies", true);
      out.member("workspaceDiagnostics", false);
      break;
    case Feature::References:
      out.member("workDoneProgress", true);
      break;
    case Feature::Rename:
      out.member("workDoneProgress", true);
      if (client.prepare_rename) out.member("prepareProvider", true);
      break;
    case Feature::SemanticTokens:
      write_semantic_tokens_options(out);
      break;
    case Feature::CodeLens:
      out.member("resolveProvider", true);
      break;
    case Feature::Completion:
      write_completion_options(out);
      break;
    case Feature::SignatureHelp:
      write_signature_help_options(out);
      break;
    case Feature::CodeAction:
      write_code_action_options(out);
      break;
    case Feature::Hover:
    case Feature::Definition:
    case Feature::DocumentHighlight:
    case Feature::DocumentSymbol:
    case Feature::InlayHint:
    case Feature::FoldingRange:
      break;
  }
}

bool is_announced(Feature feature, const InitializeParams& client, const Settings& settings) {
  if (!settings.shows(feature)) return false;
  if (feature == Feature::CodeAction && !client.code_action_literals) return false;
  const bool pulls = client.pull_diagnostics && settings.diagnostic_delivery == DiagnosticDelivery::Pull;
  return feature != Feature::Diagnostics || pulls;
}

}  // namespace texbrdf::lsp
