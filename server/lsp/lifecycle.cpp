#include <fmt/format.h>

#include <array>

#include "lsp/capabilities.h"
#include "lsp/markup.h"
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

/// Its options, or just that it is there.
void write_provider(JsonWriter& out, Feature feature, const InitializeParams& client) {
  JsonWriter options;
  options.begin_object();
  write_provider_options(options, feature, client);
  options.end_object();
  out.raw(options.text() == "{}" ? "true" : options.text());
}

void write_workspace_capabilities(JsonWriter& out) {
  out.key("workspace");
  out.begin_object();
  out.key("workspaceFolders");
  out.begin_object();
  out.member("supported", true);
  out.member("changeNotifications", true);
  out.end_object();
  out.end_object();
}

void write_experimental_capabilities(JsonWriter& out) {
  out.key("experimental");
  out.begin_object();
  out.key("texbrdf");
  out.begin_object();
  out.member("preview", true);
  out.end_object();
  out.end_object();
}

}  // namespace

Session::Outcome Session::initialize(const InitializeParams& params, JsonWriter& result) {
  if (phase_ != Phase::Created) return ResponseError{ErrorCode::InvalidRequest, "the server is initialized already"};
  phase_ = Phase::Running;
  client_ = params;
  unit_ = negotiated_unit(params.position_encodings);
  hover_markup_ = preferred_markup(params.hover_formats, features::Markup::Markdown);
  settings_ = params.settings;
  log_.set_level(chosen_log_level());
  for (const std::string& folder : params.folders) folders_.add(folder);
  documents_.projects().set_folders(folder_paths());
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
  for (const std::string& problem : client_.setting_problems) log_.warning(problem);
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
  for (const Provider& provider : providers()) {
    if (!is_announced(provider.feature, client_, settings_)) continue;
    out.key(provider.capability);
    write_provider(out, provider.feature, client_);
  }
  write_commands(out);
  write_workspace_capabilities(out);
  write_experimental_capabilities(out);
  out.end_object();
}

std::string Session::initialized(const NoParams&) {
  watch_configuration();
  watch_files();
  tell_url();
  if (client_.configuration) ask_for_configuration();
  return {};
}

Session::Outcome Session::shutdown(const NoParams&, JsonWriter& result) {
  phase_ = Phase::ShutDown;
  shut_down_ = true;
  previews_.clear();
  scene_previews_.clear();
  documents_.clear();
  scenes_.clear();
  closed_.clear();
  outbox_.forget_requests();
  result.null();
  return std::nullopt;
}

bool Session::is_switched_off(std::string_view method) const {
  const std::optional<Feature> feature = feature_of(method);
  return feature && !settings_.shows(*feature);
}

std::string Session::exit(const NoParams&) {
  phase_ = Phase::Exited;
  return {};
}

}  // namespace texbrdf::lsp
