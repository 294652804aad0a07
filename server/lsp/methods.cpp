#include "lsp/session.h"

namespace texbrdf::lsp {

void Session::bind_methods(Dispatcher& bind) {
  bind.request("initialize", *this, &Session::initialize);
  bind.notification("initialized", *this, &Session::initialized);
  bind.request("shutdown", *this, &Session::shutdown);
  bind.notification("exit", *this, &Session::exit);

  bind.notification("textDocument/didOpen", *this, &Session::did_open);
  bind.notification("textDocument/didChange", *this, &Session::did_change);
  bind.notification("textDocument/didSave", *this, &Session::did_save);
  bind.notification("textDocument/didClose", *this, &Session::did_close);

  bind.request("textDocument/hover", *this, &Session::hover);
  bind.request("textDocument/definition", *this, &Session::definition);
  bind.request("textDocument/references", *this, &Session::references);
  bind.request("textDocument/documentSymbol", *this, &Session::document_symbol);

  bind.request("texbrdf/stats", *this, &Session::stats);
}

}  // namespace texbrdf::lsp
