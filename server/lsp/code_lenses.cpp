#include "lsp/code_lenses.h"

#include <fmt/format.h>

#include <algorithm>

#include "features/code_lenses.h"
#include "lsp/params_reader.h"
#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

// Carried out by the client. One that does not announce them gets no preview, and a number of uses that does nothing.
constexpr std::string_view kPreview = "texbrdf.preview";
constexpr std::string_view kShowReferences = "texbrdf.showReferences";

bool can_carry_out(const InitializeParams& client, std::string_view command) {
  return std::ranges::find(client.commands, command) != client.commands.end();
}

void write_preview_command(JsonWriter& out, std::string_view uri, std::string_view name) {
  out.key("command");
  out.begin_object();
  out.member("title", "preview");
  out.member("command", kPreview);
  out.key("arguments");
  out.begin_array();
  out.value(uri);
  out.value(name);
  out.end_array();
  out.end_object();
}

void write_uses_command(JsonWriter& out, const CodeLensParams& lens, uint32_t uses, bool clickable) {
  out.key("command");
  out.begin_object();
  out.member("title", uses == 1 ? "1 use" : fmt::format("{} uses", uses));
  out.member("command", clickable ? kShowReferences : "");
  if (clickable) {
    out.key("arguments");
    out.begin_array();
    out.value(lens.uri);
    write_position(out, lens.range.start);
    out.end_array();
  }
  out.end_object();
}

void write_data(JsonWriter& out, std::string_view uri, std::string_view name) {
  out.key("data");
  out.begin_object();
  out.member("uri", uri);
  out.member("name", name);
  out.end_object();
}

}  // namespace

std::string read_params(nlohmann::json& params, CodeLensParams& out) {
  ParamsReader reader;
  nlohmann::json* object = reader.object_of(params);
  out.range = reader.range(reader.object(object, "range"));
  nlohmann::json* data = reader.object(object, "data");
  out.uri = reader.string(data, "uri");
  out.name = reader.string(data, "name");
  return reader.problem();
}

Session::Outcome Session::code_lens(const DocumentParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const features::CodeLensOptions options{.preview = settings_.lens_preview && can_carry_out(client_, kPreview),
                                          .uses = settings_.lens_uses};
  Positions positions(snapshot.text(), unit_);
  result.begin_array();
  for (const features::CodeLens& lens : features::code_lenses(snapshot, options)) {
    result.begin_object();
    write_range(result, "range", positions.range(lens.span));
    switch (lens.kind) {
      case features::CodeLens::Kind::Preview:
        write_preview_command(result, params.uri, lens.name);
        break;
      case features::CodeLens::Kind::Uses:
        write_data(result, params.uri, lens.name);
        break;
    }
    result.end_object();
  }
  result.end_array();
  return std::nullopt;
}

Session::Outcome Session::resolve_code_lens(const CodeLensParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const uint32_t uses = features::count_uses(open->document.snapshot(), params.name);
  result.begin_object();
  write_range(result, "range", params.range);
  write_uses_command(result, params, uses, can_carry_out(client_, kShowReferences));
  write_data(result, params.uri, params.name);
  result.end_object();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
