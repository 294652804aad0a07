#pragma once

#include <array>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace texbrdf::lsp {

/// What a client can switch off.
enum class Feature : uint8_t {
#define FEATURE(name, key, methods, description) name,
#include "lsp/settings.def"
};

inline constexpr std::size_t kFeatureCount = 0
#define FEATURE(name, key, methods, description) +1
#include "lsp/settings.def"
    ;

enum class DiagnosticDelivery : uint8_t { Push, Pull };
enum class HintSeverity : uint8_t { Off, Hint, Information, Warning };
enum class HoverPicture : uint8_t { Auto, On, Off };
enum class LogLevelChoice : uint8_t { CommandLine, Error, Warning, Info, Debug, Trace };

/// How one client wants the server, from settings.def.
struct Settings {
#define FLAG(member, key, standard, description) bool member = standard;
#define CHOICE(member, key, type, standard, words, description) type member = type::standard;
#include "lsp/settings.def"
  std::array<bool, kFeatureCount> off{};  ///< by Feature

  bool shows(Feature feature) const { return !off[static_cast<std::size_t>(feature)]; }

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// A row of the table as people read it.
struct SettingRow {
  std::string key;  ///< behind `texbrdf.`
  std::string type;
  std::string standard;  ///< its default
  std::string_view description;
};
std::vector<SettingRow> setting_rows();

/// Sets what a client's object says, whole or within a member `texbrdf`, its keys nested or dotted. Returns what it
/// does not understand, a line each; such members change nothing.
std::vector<std::string> apply_settings(const nlohmann::json& object, Settings& settings);

/// The feature that answers a method; nothing for methods that cannot be switched off.
std::optional<Feature> feature_of(std::string_view method);

}  // namespace texbrdf::lsp
