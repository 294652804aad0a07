#include "semantics/word_cuts.h"

#include <algorithm>
#include <string>

namespace texbrdf {
namespace {

constexpr size_t kLongestWord = 24;
/// Names looked up for one block; words beyond stay whole.
constexpr uint32_t kMaxLookups = 20'000;

class CutSearch {
 public:
  CutSearch(const ParsedBlock& block, const BlockNames& names, const NameTable& table, const KnownNames& known)
      : block_(block), names_(names), table_(table), known_(known) {}

  WordCuts run() {
    for (uint32_t i = 0; i < block_.definitions.size(); ++i) {
      const DefinitionSyntax& definition = block_.definitions[i];
      local_ = hidden_names(block_, definition, names_);
      for (const Binder& binder : names_.binders) local_.insert(names_.by_node[binder.variable.value]);
      for (uint32_t node = definition.left.value + 1; node <= block_.last_node(i).value; ++node) {
        const NameId name = names_.by_node[node];
        if (name.valid()) read(NodeId{node}, name);
      }
    }
    std::ranges::sort(found_.cuts);
    return std::move(found_);
  }

 private:
  bool is_defined(NameId name) const { return local_.find(name) || known_.kind(name) != NameKind::Absent; }

  void read(NodeId node, NameId name) {
    const uint32_t first = block_.tree.node(node).first_token;
    const Token& token = block_.tokens[first];
    const bool is_difference = token.kind == TokenKind::Accent && block_.token_text(first) == "\\Delta";
    const bool is_word = token.kind == TokenKind::Word && token.span.size() > 1 && token.span.size() <= kLongestWord;
    if ((!is_difference && !is_word) || is_defined(name)) return;
    const NameTraits& traits = table_.traits(name);
    const bool is_builtin = traits.builtin && block_.opens_arguments(block_.tree.node(node).end_token);
    if (traits.meaning() || is_builtin) return;
    const bool is_cut = is_difference ? cut_difference(token) : cut_word(node, token);
    if (is_cut) found_.whole.push_back(name);
    found_.has_open_words = true;
  }

  bool cut_difference(const Token& token) {
    if (!is_known("\\Delta")) return false;
    found_.cuts.push_back(token.span.begin);
    return true;
  }

  /// The longest known beginning first, and another one where the rest is not made of names.
  bool cut_word(NodeId node, const Token& token) {
    const std::string_view word = block_.slice(token.span);
    Name whole = read_name(block_, node);
    const auto is_last_piece_known = [&](size_t begin) {
      whole.base = word.substr(begin);
      return is_known(canonical_form(whole));
    };
    // By the letter that a piece begins with: the end of the longest piece after which the rest is made of names too.
    std::vector<size_t> ends(word.size(), 0);
    for (size_t begin = word.size(); begin-- > 0;) {
      if (begin > 0 && is_last_piece_known(begin)) {
        ends[begin] = word.size();
        continue;
      }
      for (size_t end = word.size() - 1; end > begin && ends[begin] == 0; --end) {
        if (ends[end] != 0 && is_known(word.substr(begin, end - begin))) ends[begin] = end;
      }
    }
    if (ends[0] == 0) return false;
    for (size_t begin = ends[0]; begin < word.size(); begin = ends[begin]) {
      found_.cuts.push_back(token.span.begin + static_cast<uint32_t>(begin));
    }
    return true;
  }

  bool is_known(std::string_view canonical) {
    if (++lookups_ > kMaxLookups) return false;
    const NameId name = table_.find(canonical);
    return name.valid() && is_defined(name);
  }

  const ParsedBlock& block_;
  const BlockNames& names_;
  const NameTable& table_;
  const KnownNames& known_;
  SmallNameMap local_;  // the parameters of the definition that is read, and all that is bound in the block
  uint32_t lookups_ = 0;
  WordCuts found_;
};

}  // namespace

WordCuts find_word_cuts(const ParsedBlock& block, const BlockNames& names, const NameTable& table,
                        const KnownNames& known) {
  return CutSearch(block, names, table, known).run();
}

}  // namespace texbrdf
