#include "lsp/semantic_tokens.h"

#include "features/semantic_tokens.h"
#include "lsp/params_reader.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

void write_names(JsonWriter& out, std::string_view key, std::span<const std::string_view> names) {
  out.key(key);
  out.begin_array();
  for (const std::string_view name : names) out.value(name);
  out.end_array();
}

void write_full(JsonWriter& out, const SemanticTokenCache& tokens) {
  out.begin_object();
  out.member("resultId", tokens.result_id());
  out.key("data");
  out.raw(tokens.data());
  out.end_object();
}

void write_delta(JsonWriter& out, const SemanticTokenCache& tokens, const SemanticTokenCache::Change& change) {
  out.begin_object();
  out.member("resultId", tokens.result_id());
  out.key("edits");
  out.begin_array();
  for (const SemanticTokenCache::Edit& edit : tokens.edits(change)) {
    out.begin_object();
    out.member("start", edit.start);
    out.member("deleteCount", edit.delete_count);
    out.key("data");
    out.begin_array();
    if (!edit.data.empty()) out.raw(edit.data);
    out.end_array();
    out.end_object();
  }
  out.end_array();
  out.end_object();
}

void write_tokens(JsonWriter& out, Positions& positions, std::span<const features::SemanticToken> tokens) {
  Position last;
  out.begin_object();
  out.key("data");
  out.begin_array();
  for (const features::SemanticToken& token : tokens) {
    const Range range = positions.range(token.span);
    const Position place = distance(last, range.start);
    out.value(place.line);
    out.value(place.column);
    out.value(range.end.column - range.start.column);
    out.value(static_cast<uint32_t>(token.type));
    out.value(token.modifiers);
    last = range.start;
  }
  out.end_array();
  out.end_object();
}

}  // namespace

std::string read_params(nlohmann::json& params, SemanticTokensDeltaParams& out) {
  ParamsReader reader;
  nlohmann::json* object = reader.object_of(params);
  out.uri = reader.document_uri(object);
  out.previous_result_id = reader.string(object, "previousResultId");
  return reader.problem();
}

void write_semantic_tokens_options(JsonWriter& out) {
  out.key("legend");
  out.begin_object();
  write_names(out, "tokenTypes", features::semantic_type_names());
  write_names(out, "tokenModifiers", features::semantic_modifier_names());
  out.end_object();
  out.member("range", true);
  out.key("full");
  out.begin_object();
  out.member("delta", true);
  out.end_object();
}

Session::Outcome Session::semantic_tokens_full(const DocumentParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  open->semantic_tokens.update(open->document.snapshot(), unit_, ++last_token_result_);
  write_full(result, open->semantic_tokens);
  return std::nullopt;
}

/// A client whose last result is not the one that is kept here gets all tokens.
Session::Outcome Session::semantic_tokens_delta(const SemanticTokensDeltaParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  SemanticTokenCache& tokens = open->semantic_tokens;
  const bool known = !params.previous_result_id.empty() && params.previous_result_id == tokens.result_id();
  const SemanticTokenCache::Change change = tokens.update(open->document.snapshot(), unit_, ++last_token_result_);
  if (known) {
    write_delta(result, tokens, change);
  } else {
    write_full(result, tokens);
  }
  return std::nullopt;
}

Session::Outcome Session::semantic_tokens_range(const RangeParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const SourceText& text = snapshot.text();
  const Span range{text.offset(params.range.start, unit_), text.offset(params.range.end, unit_)};
  Positions positions(text, unit_);
  write_tokens(result, positions, features::semantic_tokens(snapshot, range));
  return std::nullopt;
}

}  // namespace texbrdf::lsp
