#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "source/characters.h"
#include "syntax/macro_definition.h"

namespace texbrdf {

/// What a macro stands for.
struct Macro {
  uint32_t parameters = 0;
  std::optional<std::string> fallback;  ///< of the first argument
  std::string body;
  bool takes_size = false;   ///< `*` or `[\big]` may stand in front of the argument, and means nothing
  bool is_original = false;  ///< a copy of a command that is no macro: it is not expanded further
  friend bool operator==(const Macro&, const Macro&) = default;
};

/// Hashes whatever is like a string.
struct StringHash {
  using is_transparent = void;
  size_t operator()(std::string_view text) const { return std::hash<std::string_view>()(text); }
};
using WordSet = std::unordered_set<std::string, StringHash, std::equal_to<>>;

/// The macros of a document. Each holds in the whole of it: of several definitions, what TeX would have at the end.
class MacroTable {
 public:
  MacroTable() = default;
  /// In the order of the document.
  explicit MacroTable(const std::vector<const MacroDefinition*>& definitions);

  bool empty() const { return entries_.empty(); }
  /// nullptr where no macro has the name.
  const Macro* find(std::string_view name) const;
  /// Which of the definitions the macro has; nothing where there is no such macro.
  std::optional<uint32_t> definition_of(std::string_view name) const;

  /// The names whose expansion may be another than in `before`: those that are defined in another way, and those whose
  /// bodies use them.
  WordSet changed_since(const MacroTable& before) const;

 private:
  struct Entry {
    Macro macro;
    uint32_t definition = 0;
  };
  using Users = std::unordered_map<std::string_view, std::vector<std::string_view>>;

  Macro meaning_of(const MacroDefinition& definition) const;
  void list_users(Users& users) const;

  std::unordered_map<std::string, Entry, StringHash, std::equal_to<>> entries_;
};

/// Calls `visit` with every control word of the text, without its backslash, until it returns false.
template <typename Visit>
void visit_control_words(std::string_view text, const Visit& visit) {
  for (size_t at = text.find('\\'); at < text.size(); at = text.find('\\', at)) {
    const size_t begin = ++at;
    while (at < text.size() && is_letter(text[at])) ++at;
    if (at == begin) {
      ++at;
    } else if (!visit(text.substr(begin, at - begin))) {
      return;
    }
  }
}

bool holds_word_of(const WordSet& words, std::string_view text);

}  // namespace texbrdf
