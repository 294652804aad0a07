#include "lsp/token_run.h"

#include <array>
#include <charconv>

#include "lsp/text_walk.h"

namespace texbrdf::lsp {
namespace {

void append_number(std::string& out, uint32_t number) {
  std::array<char, 10> digits;
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  out.append(digits.data(), result.ptr);
}

}  // namespace

void append_place(std::string& out, Position place) {
  append_number(out, place.line);
  out += ',';
  append_number(out, place.column);
}

TokenRun encode_run(std::string_view text, std::span<const features::SemanticToken> tokens, ColumnUnit unit) {
  TokenRun run;
  TextWalk walk(text, unit);
  for (const features::SemanticToken& token : tokens) {
    const Position begin = walk.at(token.span.begin);
    const Position end = walk.at(token.span.end);
    if (run.count == 0) {
      run.first = begin;
    } else {
      run.numbers += ',';
      append_place(run.numbers, distance(run.last, begin));
      run.numbers += ',';
    }
    append_number(run.numbers, end.column - begin.column);
    run.numbers += ',';
    append_number(run.numbers, static_cast<uint32_t>(token.type));
    run.numbers += ',';
    append_number(run.numbers, token.modifiers);
    run.last = begin;
    ++run.count;
  }
  run.numbers.shrink_to_fit();
  return run;
}

}  // namespace texbrdf::lsp
