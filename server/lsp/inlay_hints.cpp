#include "features/inlay_hints.h"

#include "lsp/session.h"

namespace texbrdf::lsp {
namespace {

void write_hint(JsonWriter& out, Positions& positions, const features::InlayHint& hint) {
  constexpr int kType = 1;
  out.begin_object();
  out.key("position");
  write_position(out, positions.at(hint.offset));
  out.member("label", hint.label);
  switch (hint.kind) {
    case features::InlayHint::Kind::Type:
      out.member("kind", kType);
      break;
    case features::InlayHint::Kind::Value:  // the protocol has no kind for it
      out.member("paddingLeft", true);
      break;
  }
  out.end_object();
}

}  // namespace

Session::Outcome Session::inlay_hint(const RangeParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const SourceText& text = snapshot.text();
  const Span range{text.offset(params.range.start, unit_), text.offset(params.range.end, unit_)};
  const features::InlayHintOptions options{.definition_types = settings_.inlay_definition_types,
                                           .parameter_types = settings_.inlay_parameter_types,
                                           .constant_values = settings_.inlay_constant_values};
  Positions positions(text, unit_);
  result.begin_array();
  for (const features::InlayHint& hint : features::inlay_hints(snapshot, range, options)) {
    write_hint(result, positions, hint);
  }
  result.end_array();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
