#include "lsp/configuration.h"

#include <fmt/format.h>

#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "lsp/capabilities.h"
#include "lsp/params_reader.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

constexpr const char* kSection = "texbrdf";
constexpr const char* kConfigurationMethod = "workspace/didChangeConfiguration";

bool differs_in_hints(const Settings& a, const Settings& b) {
  return a.inlay_definition_types != b.inlay_definition_types || a.inlay_parameter_types != b.inlay_parameter_types ||
         a.inlay_constant_values != b.inlay_constant_values;
}

bool differs_in_lenses(const Settings& a, const Settings& b) {
  return a.lens_preview != b.lens_preview || a.lens_uses != b.lens_uses;
}

/// What a client has of the feature is not what it would get now.
bool is_outdated(Feature feature, const Settings& before, const Settings& now) {
  if (before.shows(feature) != now.shows(feature)) return true;
  if (feature == Feature::Diagnostics) return before.hint_severity != now.hint_severity;
  if (feature == Feature::InlayHint) return differs_in_hints(before, now);
  return feature == Feature::CodeLens && differs_in_lenses(before, now);
}

/// The protocol spells it so.
void write_unregistration(JsonWriter& out, const char* method) {
  out.begin_object();
  out.key("unregisterations");
  out.begin_array();
  out.begin_object();
  out.member("id", method);
  out.member("method", method);
  out.end_object();
  out.end_array();
  out.end_object();
}

}  // namespace

void write_registration(JsonWriter& out, const char* method, const std::function<void(JsonWriter&)>& write_options) {
  out.begin_object();
  out.key("registrations");
  out.begin_array();
  out.begin_object();
  out.member("id", method);
  out.member("method", method);
  out.key("registerOptions");
  out.begin_object();
  write_options(out);
  out.end_object();
  out.end_object();
  out.end_array();
  out.end_object();
}

std::string read_params(nlohmann::json& params, DidChangeConfigurationParams& out) {
  ParamsReader reader;
  nlohmann::json* settings = ParamsReader::optional(reader.object_of(params), "settings");
  out.settings = std::make_shared<nlohmann::json>(settings == nullptr ? nlohmann::json() : std::move(*settings));
  return reader.problem();
}

/// A client that can be asked is asked; what it sends along may be nothing, or of other servers.
std::string Session::did_change_configuration(const DidChangeConfigurationParams& params) {
  if (client_.configuration) {
    ask_for_configuration();
  } else {
    configure(*params.settings);
  }
  return {};
}

void Session::ask_for_configuration() {
  const auto write_items = [](JsonWriter& out) {
    out.begin_object();
    out.key("items");
    out.begin_array();
    out.begin_object();
    out.member("section", kSection);
    out.end_object();
    out.end_array();
    out.end_object();
  };
  outbox_.request("workspace/configuration", write_items, [this](const nlohmann::json& sections) {
    if (sections.is_array() && !sections.empty()) configure(sections.front());
  });
}

void Session::watch_configuration() {
  if (!client_.configuration_registration) return;
  outbox_.request("client/registerCapability", [](JsonWriter& out) {
    write_registration(out, kConfigurationMethod, [](JsonWriter& options) { options.member("section", kSection); });
  });
}

/// What the client sets counts before what it gave to `initialize`.
void Session::configure(const nlohmann::json& section) {
  if (!section.is_object() && !section.is_null()) {
    log_.warning("settings that are no object are ignored");
    return;
  }
  Settings wanted = client_.settings;
  for (const std::string& problem : apply_settings(section, wanted)) log_.warning(problem);
  adopt(wanted);
}

void Session::adopt(const Settings& wanted) {
  const Settings before = settings_;
  const bool pushed_before = pushes_diagnostics();
  settings_ = wanted;
  log_.set_level(chosen_log_level());
  for (const Provider& provider : providers()) {
    if (is_announced(provider.feature, client_, before) != is_announced(provider.feature, client_, wanted)) {
      announce_anew(provider);
    }
    if (is_kept(provider.feature) && is_outdated(provider.feature, before, wanted)) {
      outbox_.request(provider.refresh_method);
    }
  }
  const bool is_changed = is_outdated(Feature::Diagnostics, before, wanted);
  if (is_changed || pushed_before != pushes_diagnostics()) publish_anew(pushed_before);
}

/// The client has results of the feature and can be told to ask again.
bool Session::is_kept(Feature feature) const {
  if (feature == Feature::Diagnostics && !is_pulled()) return false;
  return client_.refresh[static_cast<std::size_t>(feature)];
}

LogLevel Session::chosen_log_level() const {
  switch (settings_.log_level) {
    case LogLevelChoice::CommandLine:
      return first_log_level_;
    case LogLevelChoice::Error:
      return LogLevel::Error;
    case LogLevelChoice::Warning:
      return LogLevel::Warning;
    case LogLevelChoice::Info:
      return LogLevel::Info;
    case LogLevelChoice::Debug:
      return LogLevel::Debug;
    case LogLevelChoice::Trace:
      return LogLevel::Trace;
  }
  return first_log_level_;
}

/// What was announced at the start stays so, and is answered with nothing; what was not has to be registered.
void Session::announce_anew(const Provider& provider) {
  if (is_announced(provider.feature, client_, client_.settings)) return;
  const auto index = static_cast<std::size_t>(provider.feature);
  if (!client_.registration[index]) {
    log_.warning(fmt::format("{} cannot be announced to this client before a restart", provider.method));
    return;
  }
  registered_[index] = !registered_[index];
  if (!registered_[index]) {
    outbox_.request("client/unregisterCapability",
                    [&](JsonWriter& out) { write_unregistration(out, provider.method); });
    return;
  }
  outbox_.request("client/registerCapability", [&](JsonWriter& out) {
    write_registration(out, provider.method, [&](JsonWriter& options) {
      options.key("documentSelector");
      options.null();
      write_provider_options(options, provider.feature, client_);
    });
  });
}

}  // namespace texbrdf::lsp
