#include "lsp/settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace texbrdf::lsp {
namespace {

using nlohmann::json;

constexpr const char* kSection = "texbrdf";
constexpr int kDeepestKey = 4;

struct FeatureRow {
  Feature feature;
  std::string_view key;
  std::string_view methods;
  std::string_view description;
};

constexpr auto kFeatures = std::to_array<FeatureRow>({
#define FEATURE(name, key, methods, description) {Feature::name, key, methods, description},
#include "lsp/settings.def"
});

std::string feature_key(const FeatureRow& row) {
  return fmt::format("features.{}", row.key);
}

/// The first word; it and the space behind it are taken away.
std::string_view take_word(std::string_view& words) {
  const std::size_t end = std::min(words.find(' '), words.size());
  const std::string_view word = words.substr(0, end);
  words.remove_prefix(std::min(end + 1, words.size()));
  return word;
}

std::vector<std::string_view> split(std::string_view words) {
  std::vector<std::string_view> result;
  while (!words.empty()) result.push_back(take_word(words));
  return result;
}

std::string alternatives(std::string_view words) {
  std::string text;
  for (const std::string_view word : split(words)) text += fmt::format("{}`\"{}\"`", text.empty() ? "" : ", ", word);
  return text;
}

std::string quoted_word(std::string_view words, std::size_t index) {
  return fmt::format("\"{}\"", split(words)[index]);
}

/// Sets one member of the settings by its key.
class Assignment {
 public:
  Assignment(Settings& settings, std::string_view key, const json& value)
      : settings_(settings), key_(key), value_(value) {}

  /// Why it could not be set, empty where it was.
  std::string run() {
    for (const FeatureRow& row : kFeatures) {
      if (key_ != feature_key(row)) continue;
      bool shown = true;
      take_flag(shown);
      if (problem_.empty()) settings_.off[static_cast<std::size_t>(row.feature)] = !shown;
    }
#define FLAG(member, key, standard, description) \
  if (key_ == (key)) take_flag(settings_.member);
#define CHOICE(member, key, type, standard, words, description) \
  if (key_ == (key)) take_choice(settings_.member, words);
#include "lsp/settings.def"
    if (!known_) return fmt::format("there is no setting {}.{}", kSection, key_);
    return problem_;
  }

 private:
  void take_flag(bool& out) {
    known_ = true;
    if (value_.is_boolean()) {
      out = value_.get<bool>();
    } else {
      problem_ = fmt::format("{}.{} has to be true or false", kSection, key_);
    }
  }
  template <typename Choice>
  void take_choice(Choice& out, std::string_view words) {
    known_ = true;
    const std::vector<std::string_view> known = split(words);
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!value_.is_string() || value_.get_ref<const std::string&>() != known[i]) continue;
      out = static_cast<Choice>(i);
      return;
    }
    problem_ = fmt::format("{}.{} has to be one of {}", kSection, key_, alternatives(words));
  }

  Settings& settings_;
  std::string_view key_;
  const json& value_;
  bool known_ = false;
  std::string problem_;
};

/// Assigns the members below an object, whose own key is `prefix`.
void apply_members(const json& object, const std::string& prefix, int depth, Settings& settings,
                   std::vector<std::string>& problems) {
  for (const auto& [name, value] : object.items()) {
    const std::string key = prefix.empty() ? name : fmt::format("{}.{}", prefix, name);
    if (value.is_null()) continue;
    if (value.is_object() && depth < kDeepestKey) {
      apply_members(value, key, depth + 1, settings, problems);
    } else if (std::string problem = Assignment(settings, key, value).run(); !problem.empty()) {
      problems.push_back(std::move(problem));
    }
  }
}

}  // namespace

std::vector<std::string> apply_settings(const json& object, Settings& settings) {
  std::vector<std::string> problems;
  if (!object.is_object()) {
    if (!object.is_null()) problems.push_back(fmt::format("the section {} has to be an object", kSection));
    return problems;
  }
  const auto section = object.find(kSection);
  if (section != object.end()) return apply_settings(*section, settings);
  apply_members(object, "", 1, settings, problems);
  return problems;
}

std::vector<SettingRow> setting_rows() {
  std::vector<SettingRow> rows;
  for (const FeatureRow& row : kFeatures) rows.push_back({feature_key(row), "boolean", "true", row.description});
#define FLAG(member, key, standard, description) \
  rows.push_back({key, "boolean", (standard) ? "true" : "false", description});
#define CHOICE(member, key, type, standard, words, description) \
  rows.push_back({key, alternatives(words), quoted_word(words, static_cast<std::size_t>(type::standard)), description});
#include "lsp/settings.def"
  return rows;
}

std::optional<Feature> feature_of(std::string_view method) {
  for (const FeatureRow& row : kFeatures) {
    for (std::string_view rest = row.methods; !rest.empty();) {
      if (take_word(rest) == method) return row.feature;
    }
  }
  return std::nullopt;
}

}  // namespace texbrdf::lsp
