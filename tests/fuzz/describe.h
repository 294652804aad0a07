#pragma once

#include <algorithm>
#include <iostream>
#include <string>
#include <string_view>

#include "analysis/document.h"
#include "emit/emit.h"
#include "source/internal_error.h"

namespace texbrdf::test {

/// All that a person could see of a document, as text.
inline std::string describe(const Snapshot& snapshot) {
  std::string result;
  for (const Diagnostic& diagnostic : snapshot.diagnostics()) {
    const Span span = snapshot.absolute(diagnostic.where);
    result += std::to_string(span.begin) + "-" + std::to_string(span.end) + " " + message(diagnostic) + "\n";
    for (const RelatedPlace& related : diagnostic.related) {
      result += std::to_string(snapshot.absolute(related.where).begin) + " " + related.message + "\n";
    }
  }
  for (uint32_t i = 0; i < snapshot.definitions().size(); ++i) {
    const Definition definition = snapshot.definition({i});
    result +=
        std::string(snapshot.names().text(definition.name)) + (definition.in_force ? " : " : " (not in force) : ") +
        std::to_string(static_cast<int>(definition.checked->signature.result)) + " " + snapshot.equation({i}) + "\n";
  }
  if (const Result<ir::Program> program = snapshot.program()) {
    if (const Result<emit::EmittedCode> code = emit::find_target("glsl")->emit(*program, {})) result += code->text;
  }
  return result;
}

inline void expect_equal(const std::string& edited, const std::string& fresh) {
  if (edited == fresh) return;
  std::cerr << "edited:\n" << edited << "\nfresh:\n" << fresh << '\n';
  throw InternalError("an edit gives something else than its text");
}

/// What stands in front of the next byte 0xFF of the input, which goes with it.
inline std::string_view take_piece(std::string_view& input) {
  const std::string_view piece = input.substr(0, input.find('\xFF'));
  input.remove_prefix(std::min(input.size(), piece.size() + 1));
  return piece;
}

inline uint32_t byte_at(std::string_view piece, std::size_t i) {
  return static_cast<unsigned char>(piece[i]);
}

}  // namespace texbrdf::test
