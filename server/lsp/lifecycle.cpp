#include <fmt/format.h>

#include <array>

#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

struct Encoding {
  std::string_view name;
  ColumnUnit unit;
};

constexpr std::array<Encoding, 3> kEncodings = {
    {{"utf-8", ColumnUnit::Utf8}, {"utf-16", ColumnUnit::Utf16}, {"utf-32", ColumnUnit::CodePoint}}};
constexpr int kIncrementalSync = 2;

/// The first of the client's encodings that is known here; without any the protocol says UTF-16.
ColumnUnit negotiated_unit(const std::vector<std::string>& offered) {
  for (const std::string& name : offered) {
    for (const Encoding& encoding : kEncodings) {
      if (encoding.name == name) return encoding.unit;
    }
  }
  return ColumnUnit::Utf16;
}

std::string_view encoding_name(ColumnUnit unit) {
  for (const Encoding& encoding : kEncodings) {
    if (encoding.unit == unit) return encoding.name;
  }
  return {};
}

features::Markup preferred_markup(const std::vector<std::string>& formats) {
  const bool plain = !formats.empty() && formats.front() == "plaintext";
  return plain ? features::Markup::PlainText : features::Markup::Markdown;
}

}  // namespace

Session::Outcome Session::initialize(const InitializeParams& params, JsonWriter& result) {
  if (phase_ != Phase::Created) return ResponseError{ErrorCode::InvalidRequest, "the server is initialized already"};
  phase_ = Phase::Running;
  client_ = params;
  unit_ = negotiated_unit(params.position_encodings);
  hover_markup_ = preferred_markup(params.hover_formats);
  greet_client();
  result.begin_object();
  result.key("capabilities");
  write_capabilities(result);
  result.key("serverInfo");
  result.begin_object();
  result.member("name", "texbrdf");
  if (!program_version_.empty()) result.member("version", program_version_);
  result.end_object();
  result.end_object();
  return std::nullopt;
}

void Session::greet_client() {
  const std::string name = client_.client_name.empty() ? "without a name" : client_.client_name;
  log_.info(fmt::format("client {} {}, positions in {}", name, client_.client_version, encoding_name(unit_)));
  if (client_.process_id && !client_process_.watch(*client_.process_id)) {
    log_.warning(fmt::format("client process {} cannot be watched", *client_.process_id));
  }
}

void Session::write_capabilities(JsonWriter& out) const {
  out.begin_object();
  out.member("positionEncoding", encoding_name(unit_));
  out.key("textDocumentSync");
  out.begin_object();
  out.member("openClose", true);
  out.member("change", kIncrementalSync);
  out.member("save", true);
  out.end_object();
  out.member("hoverProvider", true);
  out.member("definitionProvider", true);
  out.member("referencesProvider", true);
  out.member("documentSymbolProvider", true);
  out.end_object();
}

std::string Session::initialized(const NoParams&) {
  return {};
}

Session::Outcome Session::shutdown(const NoParams&, JsonWriter& result) {
  phase_ = Phase::ShutDown;
  shut_down_ = true;
  documents_ = {};
  closed_.clear();
  result.null();
  return std::nullopt;
}

std::string Session::exit(const NoParams&) {
  phase_ = Phase::Exited;
  return {};
}

}  // namespace texbrdf::lsp
