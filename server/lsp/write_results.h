#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "features/definition.h"
#include "features/diagnostics.h"
#include "features/hover.h"
#include "lsp/json_writer.h"
#include "lsp/positions.h"

namespace texbrdf::lsp {

/// Results of features as the protocol's JSON.

/// As the protocol counts them.
int severity_number(Severity severity);
void write_position(JsonWriter& out, Position position);
void write_range(JsonWriter& out, std::string_view key, Range range);

void write_hover(JsonWriter& out, Positions& positions, const features::Hover& hover, features::Markup markup);
void write_definition_link(JsonWriter& out, Positions& positions, std::string_view uri,
                           const features::DefinitionLink& link);
void write_location(JsonWriter& out, Positions& positions, std::string_view uri, Span span);
/// `uri` and `range` of an object that has more.
void write_location_members(JsonWriter& out, Positions& positions, std::string_view uri, Span span);
/// Location[]
void write_locations(JsonWriter& out, Positions& positions, std::string_view uri, std::span<const Span> spans);

/// What the client understands of a diagnostic beyond its place and text.
struct DiagnosticStyle {
  bool related_information = false;
  bool code_description = false;
  bool tags = false;
  std::string_view docs_url;  ///< of the page with an anchor for each code
};

/// Diagnostic[]
void write_diagnostic_items(JsonWriter& out, Positions& positions, std::string_view uri,
                            std::span<const features::ShownDiagnostic> diagnostics, const DiagnosticStyle& style);

/// PublishDiagnosticsParams
void write_diagnostics(JsonWriter& out, Positions& positions, std::string_view uri, std::optional<int64_t> version,
                       std::span<const features::ShownDiagnostic> diagnostics, const DiagnosticStyle& style);

}  // namespace texbrdf::lsp
