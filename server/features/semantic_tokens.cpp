#include "features/semantic_tokens.h"

#include <algorithm>
#include <array>
#include <optional>

namespace texbrdf::features {
namespace {

constexpr auto kTypeNames = std::to_array<std::string_view>({
#define SEMANTIC_TYPE(name, text) text,
#include "features/semantic_tokens.def"
#undef SEMANTIC_TYPE
});

constexpr auto kModifierNames = std::to_array<std::string_view>({
#define SEMANTIC_MODIFIER(name, text) text,
#include "features/semantic_tokens.def"
#undef SEMANTIC_MODIFIER
});

struct FixedToken {
  TokenKind kind;
  SemanticType type;
};

constexpr auto kFixedTokens = std::to_array<FixedToken>({
#define SEMANTIC_TOKEN(kind, type) {TokenKind::kind, SemanticType::type},
#include "features/semantic_tokens.def"
#undef SEMANTIC_TOKEN
});

constexpr std::size_t kTokenKinds = static_cast<std::size_t>(TokenKind::End) + 1;

/// By TokenKind.
constexpr auto kTypes = [] {
  std::array<std::optional<SemanticType>, kTokenKinds> types;
  for (const FixedToken& fixed : kFixedTokens) types[static_cast<std::size_t>(fixed.kind)] = fixed.type;
  return types;
}();

constexpr uint32_t bit(SemanticModifier modifier) {
  return uint32_t{1} << static_cast<uint32_t>(modifier);
}

/// A name of the block: its tokens, and how it is shown.
struct ShownName {
  uint32_t first_token;
  uint32_t end_token;
  SemanticType type;
  uint32_t modifiers;
};

/// Reads the names of one block, definition by definition.
class NameReader {
 public:
  NameReader(const ParsedBlock& block, const BlockNames& names, const NameTable& table, const HiddenConventions& hidden)
      : block_(block), names_(names), table_(table), hidden_(hidden), is_called_(block.tree.size()) {}

  /// In the order of their tokens.
  std::vector<ShownName> read() {
    uint32_t next = 0;
    for (const DefinitionSyntax& definition : block_.definitions) {
      read_nodes(next, definition.first_node);
      read_definition(definition);
      next = definition.node.value + 1;
    }
    read_nodes(next, block_.tree.size());
    std::ranges::sort(shown_, {}, &ShownName::first_token);
    return std::move(shown_);
  }

 private:
  void read_definition(const DefinitionSyntax& definition) {
    parameters_.clear();
    const bool is_function = block_.tree.node(definition.left).kind == NodeKind::Signature;
    add(definition.name, is_function ? SemanticType::Function : SemanticType::Variable,
        bit(SemanticModifier::Definition));
    if (is_function) {
      for (const NodeId parameter : block_.tree.children(definition.left).subspan(1)) {
        const NodeId name = block_.parameter_name(parameter);
        if (!name.valid() || !name_of(name.value).valid()) continue;
        parameters_.push_back(name_of(name.value));
        add(name, SemanticType::Parameter, bit(SemanticModifier::Declaration));
      }
      std::ranges::sort(parameters_);
      read_expressions(definition.left);
    }
    read_nodes(definition.left.value + 1, definition.node.value);
    parameters_.clear();
  }

  /// Names in `f(\phi_r - \phi_i)`, which mean what they mean in the document.
  void read_expressions(NodeId signature) {
    uint32_t behind = block_.tree.child(signature, 0).value + 1;
    for (const NodeId parameter : block_.tree.children(signature).subspan(1)) {
      if (!block_.parameter_name(parameter).valid()) read_nodes(behind, parameter.value + 1);
      behind = parameter.value + 1;
    }
  }

  void read_nodes(uint32_t begin, uint32_t end) {
    for (uint32_t node = begin; node < end; ++node) {
      if (block_.tree.node(NodeId{node}).kind == NodeKind::Apply) {
        is_called_[block_.tree.child(NodeId{node}, 0).value] = true;
      }
    }
    for (uint32_t node = begin; node < end; ++node) {
      if (name_of(node).valid()) read_reference(NodeId{node});
    }
  }

  void read_reference(NodeId node) {
    const NameId name = name_of(node.value);
    const bool is_convention = table_.traits(name).meaning().has_value();
    if (names_.bound_use(node) != nullptr || std::ranges::binary_search(parameters_, name)) {
      add(node, SemanticType::Parameter, 0);
    } else if (is_convention && !hidden_.contains(name)) {
      add(node, SemanticType::Variable, bit(SemanticModifier::DefaultLibrary));
    } else {
      add(node, is_called_[node.value] ? SemanticType::Function : SemanticType::Variable, 0);
    }
  }

  NameId name_of(uint32_t node) const { return names_.by_node[node]; }

  void add(NodeId node, SemanticType type, uint32_t modifiers) {
    const Node& name = block_.tree.node(node);
    shown_.push_back({name.first_token, name.end_token, type, modifiers});
  }

  const ParsedBlock& block_;
  const BlockNames& names_;
  const NameTable& table_;
  const HiddenConventions& hidden_;
  std::vector<bool> is_called_;     // by node
  std::vector<NameId> parameters_;  // of the definition that is read, sorted
  std::vector<ShownName> shown_;
};

/// What goes on in the next line becomes a token on each, without the white space around.
void add_lines(std::vector<SemanticToken>& tokens, const ParsedBlock& block, SemanticToken token) {
  const std::string_view text = block.slice(token.span);
  if (text.find_first_of("\r\n") == std::string_view::npos) {
    tokens.push_back(token);
    return;
  }
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    if (begin == end) return;
    const std::size_t last = text.find_last_not_of(" \t", end - 1);
    SemanticToken piece = token;
    piece.span.begin = token.span.begin + static_cast<uint32_t>(begin);
    piece.span.end = token.span.begin + static_cast<uint32_t>(last + 1);
    tokens.push_back(piece);
    at = end;
  }
}

/// Those that stand in the source, and the macros in it.
std::vector<SemanticToken> tokens_in_source(const std::vector<SemanticToken>& tokens, const MacroExpansion& expansion) {
  std::vector<SemanticToken> result;
  for (SemanticToken token : tokens) {
    if (!expansion.is_written(token.span)) continue;
    token.span = expansion.in_source(token.span);
    result.push_back(token);
  }
  for (const MacroUse& use : expansion.uses()) result.push_back({use.command, SemanticType::Macro, 0});
  // An argument may stand in the expansion twice, or behind one that follows it.
  std::ranges::stable_sort(result, {}, &SemanticToken::span);
  uint32_t end = 0;
  std::erase_if(result, [&](const SemanticToken& token) {
    if (token.span.begin < end) return true;
    end = token.span.end;
    return false;
  });
  return result;
}

}  // namespace

std::span<const std::string_view> semantic_type_names() {
  return kTypeNames;
}
std::span<const std::string_view> semantic_modifier_names() {
  return kModifierNames;
}

HiddenConventions::HiddenConventions(const Snapshot& snapshot) {
  const auto add = [&](std::string_view spelling) {
    const NameId name = snapshot.names().find(spelling);
    if (name.valid() && snapshot.find(name)) defined_.push_back(name);
  };
  for (const ConventionEntry& entry : conventions()) {
    if (!entry.spellings.empty()) add(entry.spellings.front());
  }
  for (const UsualName& usual : usual_names()) add(usual.spelling);
  std::ranges::sort(defined_);
}

std::vector<SemanticToken> block_tokens(const Snapshot& snapshot, BlockId block, const HiddenConventions& hidden) {
  const ParsedBlock& parsed = snapshot.parsed(block);
  const std::vector<ShownName> names = NameReader(parsed, snapshot.names_of(block), snapshot.names(), hidden).read();
  std::vector<SemanticToken> tokens;
  tokens.reserve(parsed.tokens.size());
  auto name = names.begin();
  for (uint32_t token = 0; token < parsed.tokens.size();) {
    while (name != names.end() && name->first_token < token) ++name;
    if (name != names.end() && name->first_token == token) {
      const Span span = join(parsed.tokens[token].span, parsed.tokens[name->end_token - 1].span);
      add_lines(tokens, parsed, {span, name->type, name->modifiers});
      token = name->end_token;
      continue;
    }
    const std::optional<SemanticType> type = kTypes[static_cast<std::size_t>(parsed.tokens[token].kind)];
    if (type) add_lines(tokens, parsed, {parsed.tokens[token].span, *type, 0});
    ++token;
  }
  if (parsed.expansion) return tokens_in_source(tokens, *parsed.expansion);
  return tokens;
}

std::vector<SemanticToken> semantic_tokens(const Snapshot& snapshot, Span range) {
  std::vector<SemanticToken> tokens;
  const HiddenConventions hidden(snapshot);
  const auto count = static_cast<uint32_t>(snapshot.blocks().size());
  for (uint32_t i = snapshot.block_at(range.begin).value_or(BlockId{}).value; i < count; ++i) {
    const BlockId block{i};
    if (snapshot.absolute(block, {}).begin > range.end) break;
    const uint32_t offset = snapshot.absolute(block, {}).begin;
    for (SemanticToken token : block_tokens(snapshot, block, hidden)) {
      token.span = {offset + token.span.begin, offset + token.span.end};
      if (token.span.begin <= range.end && token.span.end >= range.begin) tokens.push_back(token);
    }
  }
  return tokens;
}

}  // namespace texbrdf::features
