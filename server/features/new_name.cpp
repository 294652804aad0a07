#include "features/new_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "semantics/names.h"
#include "source/trimmed.h"
#include "syntax/block_scanner.h"
#include "syntax/control_words.h"
#include "syntax/parsed_block.h"

namespace texbrdf::features {
namespace {

/// It may come to stand in thousands of places.
constexpr std::size_t kLongestName = 1000;

bool is_command(std::string_view text) {
  if (!text.starts_with('\\')) return false;
  return find_control_word(text.substr(1)).meaning != WordMeaning::Name;
}

/// The left side of an equation that holds nothing but the text; empty where the text is not one name.
std::string canonical_of(std::string_view text) {
  const std::string equation = fmt::format("\\begin{{equation}}{}=0\\end{{equation}}", text);
  const std::vector<BlockExtent> extents = scan_blocks(equation);
  if (extents.size() != 1 || extents[0].whole.size() != equation.size()) return {};
  const ParsedBlock block = parse_block(equation, extents[0]);
  if (!block.diagnostics.empty() || !block.comments.empty() || block.definitions.size() != 1) return {};
  const NodeId left = block.definitions[0].left;
  if (block.tree.node(left).kind != NodeKind::Name || block.node_text(left) != text) return {};
  return canonical_form(read_name(block, left));
}

}  // namespace

Result<NewName> read_new_name(std::string_view typed) {
  const std::string_view text = trimmed(typed, " \t");
  if (text.empty()) return Failure{"the new name is empty"};
  if (text.size() > kLongestName) return Failure{"the name is too long"};
  if (is_command(text)) return Failure{fmt::format("`{}` is a command, not a name", text)};
  const bool has_controls = std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  std::string canonical = has_controls ? std::string{} : canonical_of(text);
  if (canonical.empty()) return Failure{fmt::format("`{}` is not a name", text)};
  const NameTraits traits = name_traits(canonical);
  if (traits.is_reserved) return Failure{fmt::format("`{}` is a reserved word", text)};
  if (traits.convention) return Failure{fmt::format("`{}` is a convention of the language", text)};
  return NewName{std::string(text), std::move(canonical), traits};
}

}  // namespace texbrdf::features
