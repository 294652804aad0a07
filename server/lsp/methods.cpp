#include "lsp/session.h"

namespace texbrdf::lsp {

void Session::bind_methods(Dispatcher& bind) {
  bind.request("initialize", *this, &Session::initialize);
  bind.notification("initialized", *this, &Session::initialized);
  bind.request("shutdown", *this, &Session::shutdown);
  bind.notification("exit", *this, &Session::exit);

  bind.notification("workspace/didChangeConfiguration", *this, &Session::did_change_configuration);
  bind.notification("workspace/didChangeWatchedFiles", *this, &Session::did_change_watched_files);
  bind.notification("workspace/didChangeWorkspaceFolders", *this, &Session::did_change_workspace_folders);

  bind.request("workspace/executeCommand", *this, &Session::execute_command);

  bind.notification("textDocument/didOpen", *this, &Session::did_open);
  bind.notification("textDocument/didChange", *this, &Session::did_change);
  bind.notification("textDocument/didSave", *this, &Session::did_save);
  bind.notification("textDocument/didClose", *this, &Session::did_close);

  bind.request("textDocument/hover", *this, &Session::hover);
  bind.request("textDocument/definition", *this, &Session::definition);
  bind.request("textDocument/references", *this, &Session::references);
  bind.request("textDocument/documentSymbol", *this, &Session::document_symbol);
  bind.request("textDocument/diagnostic", *this, &Session::diagnostic);
  bind.request("textDocument/prepareRename", *this, &Session::prepare_rename);
  bind.request("textDocument/rename", *this, &Session::rename);

  bind.request("textDocument/semanticTokens/full", *this, &Session::semantic_tokens_full);
  bind.request("textDocument/semanticTokens/full/delta", *this, &Session::semantic_tokens_delta);
  bind.request("textDocument/semanticTokens/range", *this, &Session::semantic_tokens_range);
  bind.request("textDocument/completion", *this, &Session::completion);
  bind.request("completionItem/resolve", *this, &Session::resolve_completion);
  bind.request("textDocument/signatureHelp", *this, &Session::signature_help);
  bind.request("textDocument/codeAction", *this, &Session::code_action);
  bind.request("textDocument/documentHighlight", *this, &Session::document_highlight);
  bind.request("textDocument/foldingRange", *this, &Session::folding_range);
  bind.request("textDocument/inlayHint", *this, &Session::inlay_hint);
  bind.request("textDocument/codeLens", *this, &Session::code_lens);
  bind.request("codeLens/resolve", *this, &Session::resolve_code_lens);

  bind.request("texbrdf/openPreview", *this, &Session::open_preview);
  bind.notification("texbrdf/updatePreview", *this, &Session::update_preview);
  bind.notification("texbrdf/closePreview", *this, &Session::close_preview);
  bind.notification("texbrdf/frameShown", *this, &Session::frame_shown);
  bind.request("texbrdf/openScene", *this, &Session::open_scene);
  bind.notification("texbrdf/updateScene", *this, &Session::update_scene);
  bind.notification("texbrdf/sceneInput", *this, &Session::scene_input);
  bind.notification("texbrdf/setParameter", *this, &Session::set_parameter);
  bind.request("texbrdf/parameters", *this, &Session::parameters);
  bind.request("texbrdf/parameterEdit", *this, &Session::parameter_edit);
  bind.request("texbrdf/roots", *this, &Session::roots);
  bind.request("texbrdf/emit", *this, &Session::emit);
  bind.request("texbrdf/definitions", *this, &Session::quantities);
  bind.request("texbrdf/probe", *this, &Session::probe);
  bind.request("texbrdf/badPixels", *this, &Session::bad_pixels);
  bind.request("texbrdf/plot", *this, &Session::plot);
  bind.request("texbrdf/applyEdit", *this, &Session::apply_edit);
  bind.request("texbrdf/reveal", *this, &Session::reveal);
  bind.request("texbrdf/stats", *this, &Session::stats);
}

}  // namespace texbrdf::lsp
