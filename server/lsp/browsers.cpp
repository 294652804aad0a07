#include "lsp/browsers.h"

#include <algorithm>
#include <array>
#include <utility>

#include "lsp/json_rpc.h"
#include "lsp/uri.h"

namespace texbrdf::lsp {
namespace {

constexpr auto kMethods = std::to_array<std::string_view>({
    "texbrdf/openPreview",
    "texbrdf/updatePreview",
    "texbrdf/closePreview",
    "texbrdf/frameShown",
    "texbrdf/openScene",
    "texbrdf/updateScene",
    "texbrdf/sceneInput",
    "texbrdf/setParameter",
    "texbrdf/parameters",
    "texbrdf/parameterEdit",
    "texbrdf/roots",
    "texbrdf/definitions",
    "texbrdf/probe",
    "texbrdf/badPixels",
    "texbrdf/plot",
    "texbrdf/emit",
    "texbrdf/applyEdit",
    "texbrdf/reveal",
});

std::string name_of(std::string_view uri) {
  std::string path = shown_path(uri);
  return path.substr(path.rfind('/') + 1);
}

void write_document(JsonWriter& out, const std::optional<FollowedDocument>& document) {
  out.begin_object();
  if (document) {
    out.member("uri", document->uri);
    out.member("name", name_of(document->uri));
    out.member("version", document->version);
  } else {
    out.key("uri");
    out.null();
  }
  out.end_object();
}

}  // namespace

bool is_for_browsers(std::string_view method) {
  return std::ranges::find(kMethods, method) != kMethods.end();
}

void Browsers::connect(std::string url, Send send) {
  url_ = std::move(url);
  send_ = std::move(send);
}

void Browsers::add(ViewerId browser) {
  present_.insert(browser);
  notify(browser, "texbrdf/welcome", [&](JsonWriter& out) {
    out.begin_object();
    out.member("client", browser);
    out.end_object();
  });
  tell_document(browser);
}

void Browsers::notify(ViewerId browser, std::string_view method, const WriteParams& write_params) const {
  JsonWriter message;
  begin_notification(message, method);
  write_params(message);
  message.end_object();
  send(browser, message.take());
}

void Browsers::follow(std::optional<FollowedDocument> document) {
  if (document == document_) return;
  document_ = std::move(document);
  for (const ViewerId browser : present_) tell_document(browser);
}

void Browsers::tell_document(ViewerId browser) const {
  notify(browser, "texbrdf/document", [&](JsonWriter& out) { write_document(out, document_); });
}

}  // namespace texbrdf::lsp
