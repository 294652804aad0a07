#include "analysis/equation_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "source/characters.h"

namespace texbrdf {
namespace {

// Commands between tokens that say nothing about the equation itself.
constexpr auto kLayoutCommands =
    std::to_array<std::string_view>({"\\label", "\\tag", "\\nonumber", "\\notag", "\\displaystyle"});

class LineWriter {
 public:
  void add_token(std::string_view text) {
    for (char c : text) {
      if (is_space(c)) {
        add_space();
      } else {
        out_ += c;
      }
    }
  }

  // What stands between two tokens: white space, comments and commands that mean nothing.
  void add_gap(std::string_view gap) {
    while (!gap.empty()) {
      if (gap.front() == '%') {
        gap.remove_prefix(std::min(gap.find_first_of("\r\n"), gap.size()));
      } else if (is_space(gap.front())) {
        add_space();
        gap.remove_prefix(1);
      } else if (const size_t layout = layout_length(gap)) {
        gap.remove_prefix(layout);
      } else {
        const size_t length = gap.front() == '\\' ? std::min<size_t>(2, gap.size()) : 1;
        out_ += gap.substr(0, length);
        gap.remove_prefix(length);
      }
    }
  }

  std::string take() { return std::move(out_); }

 private:
  void add_space() {
    if (!out_.empty() && out_.back() != ' ') out_ += ' ';
  }

  static size_t layout_length(std::string_view gap) {
    for (std::string_view command : kLayoutCommands) {
      if (!gap.starts_with(command)) continue;
      size_t length = command.size();
      if (is_letter(command.back()) && length < gap.size() && is_letter(gap[length])) continue;
      const size_t open = std::min(gap.find_first_not_of(" \t", length), gap.size());
      if (open < gap.size() && gap[open] == '{') length = std::min(gap.find('}', open), gap.size() - 1) + 1;
      return length;
    }
    return 0;
  }

  std::string out_;
};

}  // namespace

std::string one_line(const ParsedBlock& block, NodeId id) {
  const Node& node = block.tree.node(id);
  LineWriter line;
  uint32_t end = block.tokens[node.first_token].span.begin;
  for (uint32_t token = node.first_token; token < node.end_token; ++token) {
    const Span span = block.tokens[token].span;
    line.add_gap(block.slice({end, span.begin}));
    line.add_token(is_layout(block.tokens[token].kind) ? " " : block.slice(span));
    end = span.end;
  }
  return line.take();
}

}  // namespace texbrdf
