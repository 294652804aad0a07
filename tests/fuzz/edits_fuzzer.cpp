// Any edits of any document: what is kept from before an edit gives what a new document with the same text gives. An
// input is the document, then edits, each behind a byte 0xFF: two bytes of place, one of length, and the new text.
#include <cstdint>
#include <iostream>
#include <string>
#include <string_view>

#include "analysis/document.h"
#include "emit/emit.h"
#include "source/internal_error.h"

namespace {

using namespace texbrdf;

constexpr std::size_t kMaxInput = 1 << 13;
constexpr char kNextEdit = '\xFF';
constexpr int kMaxEdits = 24;

/// All that a person could see of a document, as text.
std::string describe(const Snapshot& snapshot) {
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
    if (const Result<std::string> code = emit::find_target("glsl")->emit(*program, {})) result += *code;
  }
  return result;
}

std::string_view take_piece(std::string_view& input) {
  const std::string_view piece = input.substr(0, input.find(kNextEdit));
  input.remove_prefix(std::min(input.size(), piece.size() + 1));
  return piece;
}

void apply(std::string_view edit, Document& document) {
  if (edit.size() < 3) return;
  const auto byte = [&edit](std::size_t i) { return static_cast<uint32_t>(static_cast<unsigned char>(edit[i])); };
  const uint32_t begin = (byte(0) * 256 + byte(1)) % (document.text().size() + 1);
  document.replace({begin, begin + byte(2)}, edit.substr(3));
}

void expect_equal(const std::string& edited, const std::string& fresh) {
  if (edited == fresh) return;
  std::cerr << "edited:\n" << edited << "\nfresh:\n" << fresh << '\n';
  throw InternalError("an edit gives something else than its text");
}

std::string text_of(const SourceText& text) {
  return std::string(text.slice({0, text.size()}));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  std::string_view input(reinterpret_cast<const char*>(data), size);
  Document document{std::string(take_piece(input))};
  document.snapshot();
  for (int i = 0; i < kMaxEdits && !input.empty(); ++i) {
    apply(take_piece(input), document);
    Document fresh(text_of(document.text()));
    expect_equal(describe(document.snapshot()), describe(fresh.snapshot()));
  }
  return 0;
}
