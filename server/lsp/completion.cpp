#include "lsp/completion.h"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>

#include "lsp/markup.h"
#include "lsp/params_reader.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

using features::CompletionKind;

constexpr auto kKinds = std::to_array<std::pair<std::string_view, CompletionKind>>({
    {"parameter", CompletionKind::Parameter},
    {"definition", CompletionKind::Definition},
    {"macro", CompletionKind::Macro},
    {"convention", CompletionKind::Convention},
    {"builtin", CompletionKind::Builtin},
    {"command", CompletionKind::Command},
    {"letter", CompletionKind::Letter},
});

std::string_view kind_name(CompletionKind kind) {
  for (const auto& [name, known] : kKinds) {
    if (known == kind) return name;
  }
  return {};
}

std::optional<CompletionKind> kind_of(std::string_view name) {
  for (const auto& [known, kind] : kKinds) {
    if (known == name) return kind;
  }
  return std::nullopt;
}

/// Only those that the first version of the protocol has: every client knows them.
int kind_number(const features::CompletionItem& item) {
  constexpr int kText = 1;
  constexpr int kFunction = 3;
  constexpr int kVariable = 6;
  constexpr int kValue = 12;
  constexpr int kKeyword = 14;
  constexpr int kSnippet = 15;
  switch (item.kind) {
    case CompletionKind::Parameter:
      return kVariable;
    case CompletionKind::Definition:
      return item.is_function ? kFunction : kVariable;
    case CompletionKind::Macro:
      return item.is_snippet ? kSnippet : kText;
    case CompletionKind::Convention:
      return kValue;
    case CompletionKind::Builtin:
      return kFunction;
    case CompletionKind::Command:
      return item.is_snippet ? kSnippet : kKeyword;
    case CompletionKind::Letter:
      return kText;
  }
  return kText;
}

void write_item(JsonWriter& out, const features::CompletionItem& item, Range replaced, const features::Completions& all,
                std::string_view uri) {
  constexpr int kSnippetFormat = 2;
  out.begin_object();
  out.member("label", item.label);
  out.member("kind", kind_number(item));
  if (!item.detail.empty()) out.member("detail", item.detail);
  out.member("sortText", fmt::format("{}{}", static_cast<int>(item.fit), static_cast<int>(item.kind)));
  if (!item.filter.empty()) out.member("filterText", item.filter);
  if (item.is_snippet) out.member("insertTextFormat", kSnippetFormat);
  out.key("textEdit");
  out.begin_object();
  write_range(out, "range", replaced);
  out.member("newText", item.new_text);
  out.end_object();
  out.key("data");
  out.begin_object();
  out.member("uri", uri);
  out.member("kind", kind_name(item.kind));
  const bool may_follow = item.kind == CompletionKind::Parameter || item.kind == CompletionKind::Convention;
  if (may_follow && !all.function.empty()) out.member("function", all.function);
  out.end_object();
  out.end_object();
}

}  // namespace

std::string read_params(nlohmann::json& params, CompletionItemParams& out) {
  ParamsReader reader;
  nlohmann::json* object = reader.object_of(params);
  if (object == nullptr) return reader.problem();
  for (const auto& [name, value] : object->items()) {
    if (name != "documentation") out.members.emplace_back(name, value.dump());
  }
  out.label = reader.string(object, "label");
  nlohmann::json* data = ParamsReader::optional(object, "data");
  out.uri = ParamsReader::text_or_empty(data, "uri");
  out.kind = ParamsReader::text_or_empty(data, "kind");
  out.function = ParamsReader::text_or_empty(data, "function");
  return reader.problem();
}

void write_completion_options(JsonWriter& out) {
  out.key("triggerCharacters");
  out.begin_array();
  for (const char* character : {"\\", "{", "_"}) out.value(character);
  out.end_array();
  out.member("resolveProvider", true);
}

Session::Outcome Session::completion(const PositionParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const uint32_t offset = snapshot.text().offset(params.position, unit_);
  const auto found = features::complete(snapshot, offset, open->name_index, {.snippets = client_.snippets});
  if (!found.in_math) {
    result.null();
    return std::nullopt;
  }
  Positions positions(snapshot.text(), unit_);
  const Range replaced = positions.range(found.replaced);
  result.begin_object();
  result.member("isIncomplete", !found.complete);
  result.key("items");
  result.begin_array();
  for (const features::CompletionItem& item : found.items) write_item(result, item, replaced, found, params.uri);
  result.end_array();
  result.end_object();
  return std::nullopt;
}

/// What nothing is known of any more comes back as it was sent.
Session::Outcome Session::resolve_completion(const CompletionItemParams& params, JsonWriter& result) {
  const features::Markup markup = preferred_markup(client_.completion_formats, features::Markup::PlainText);
  OpenDocument* open = documents_.find(params.uri);
  const auto kind = kind_of(params.kind);
  std::string documentation;
  if (open != nullptr && kind) {
    documentation =
        features::describe_completion(open->document.snapshot(), *kind, params.label, params.function, markup);
  }
  result.begin_object();
  for (const auto& [name, json] : params.members) {
    result.text_key(name);
    result.raw(json);
  }
  if (!documentation.empty()) write_markup(result, "documentation", documentation, markup);
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
