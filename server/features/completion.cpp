#include "features/completion.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "features/caret.h"
#include "features/completion_commands.h"
#include "features/completion_text.h"
#include "features/demand.h"
#include "semantics/builtin_functions.h"
#include "semantics/name_traits.h"
#include "source/utf8.h"
#include "syntax/control_words.h"

namespace texbrdf::features {
namespace {

/// So many names are looked at; of more, those that are defined near the caret.
constexpr std::size_t kMostExamined = 200;
/// Definitions in either direction that are near.
constexpr uint32_t kFarthest = 60;

constexpr std::size_t kLongestDetail = 60;

std::vector<std::string_view> words_of(std::string_view spellings) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < spellings.size();) {
    const std::size_t end = std::min(spellings.find(' ', begin), spellings.size());
    words.push_back(spellings.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

/// `(#, #)` for two arguments.
std::string places_for(const Signature& signature) {
  std::string places = "(";
  for (std::size_t i = 0; i < signature.parameters.size(); ++i) places += i == 0 ? "#" : ", #";
  return places + ")";
}

/// On one line.
std::string shortened(std::string_view body) {
  std::string line;
  for (const char c : body) {
    const bool is_space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (!is_space) {
      line += c;
    } else if (!line.empty() && !line.ends_with(' ')) {
      line += ' ';
    }
  }
  if (line.size() <= kLongestDetail) return line;
  std::size_t end = 0;
  while (end < kLongestDetail) end += code_point_at_front(std::string_view(line).substr(end)).size;
  return line.substr(0, end) + "…";
}

/// A definition whose name begins as what is typed.
struct Candidate {
  DefinitionId definition;
  Fit fit;
};

class Completer {
 public:
  Completer(const Snapshot& snapshot, const Caret& caret, NameIndex& index, const CompletionOptions& options)
      : snapshot_(snapshot), caret_(caret), block_(snapshot.parsed(caret.block)), index_(index), options_(options) {
    // On the left side a name is made, of letters; on the right one that exists is meant.
    const Span typed = caret.is_left_side ? caret.word : caret.typed;
    typed_ = block_.slice(typed);
    key_ = typed_.starts_with('\\') ? search_key(typed_) : bare_search_key(typed_);
    replaced_ = {typed.begin, end_of_replaced(typed)};
    find_inside();
  }

  Completions run() {
    found_.in_math = true;
    found_.replaced = snapshot_.absolute(caret_.block, replaced_);
    if (caret_.is_left_side) {
      if (is_in_signature()) add_conventions();
      add_letters();
    } else {
      demanded_ = demanded_type(snapshot_, caret_.block, caret_.typed_token, caret_.brackets);
      add_parameters();
      add_bound_names();
      add_definitions();
      add_conventions();
      if (!key_.empty()) add_builtins();
    }
    if (caret_.typed.begin == caret_.word.begin) {
      add_macros();
      add_commands();
    }
    std::ranges::stable_sort(found_.items, {},
                             [](const CompletionItem& item) { return std::tuple(item.fit, item.kind); });
    return std::move(found_);
  }

 private:
  /// The closers behind the caret of braces that `typed` opens are replaced too: editors put them there.
  uint32_t end_of_replaced(Span typed) const {
    const std::string_view text = block_.slice(typed);
    auto open = std::ranges::count(text, '{') - std::ranges::count(text, '}');
    uint32_t end = typed.end;
    const auto closes = [&] {
      return end < block_.extent.content.end && block_.text[end] == '}' &&
             block_.is_replaceable({typed.begin, end + 1});
    };
    for (; open > 0 && closes(); --open) ++end;
    return end;
  }

  /// The definition in which the caret stands.
  void find_inside() {
    const DefinitionRange definitions = snapshot_.definitions_of(caret_.block);
    for (uint32_t id = definitions.first.value; id < definitions.end.value; ++id) {
      const Node& node = block_.tree.node(snapshot_.syntax(DefinitionId{id}).node);
      if (block_.tokens[node.first_token].span.begin <= caret_.offset) inside_ = DefinitionId{id};
    }
  }

  bool is_in_signature() const {
    const OpenBracket* bracket = caret_.innermost();
    return bracket != nullptr && bracket->role == OpenBracket::Role::Call;
  }

  Fit fit_of(Type type) const {
    if (!demanded_) return Fit::Good;
    if (type == Type::Error) return Fit::Unknown;
    const bool fit =
        *demanded_ == Type::Vector ? fits(type, Type::Vector) : is_componentwise(type) || fits(type, *demanded_);
    return fit ? Fit::Good : Fit::Bad;
  }

  bool matches(std::string_view name) const { return starts_with_key(name, key_); }

  CompletionItem item(CompletionKind kind, std::string_view label, Type type) const {
    CompletionItem added;
    added.kind = kind;
    added.fit = fit_of(type);
    added.label = in_typed_decoration(label);
    added.new_text = added.label;
    added.filter = filter_text(added.label, typed_, key_);
    return added;
  }

  /// `\mathbf{n}` for somebody who has typed `\mathbf{`.
  std::string in_typed_decoration(std::string_view label) const {
    constexpr std::string_view kVec = "\\vec{";
    const std::size_t brace = typed_.find('{');
    const bool is_decorated = label.starts_with(kVec) && typed_.starts_with('\\') && brace != std::string_view::npos;
    if (!is_decorated || find_control_word(typed_.substr(1, brace - 1)).meaning != WordMeaning::Vec) {
      return std::string(label);
    }
    return std::string(typed_.substr(0, brace + 1)).append(label.substr(kVec.size()));
  }

  void add_parameters() {
    if (!inside_.valid()) return;
    const Definition& definition = snapshot_.definition(inside_);
    if (definition.checked->signature.is_function) found_.function = snapshot_.names().text(definition.name);
    for (const CheckedParameter& parameter : definition.checked->parameters) {
      if (!parameter.name.valid()) continue;
      hidden_.push_back(parameter.name);
      const std::string_view name = snapshot_.names().text(parameter.name);
      if (!matches(name)) continue;
      CompletionItem added = item(CompletionKind::Parameter, name, parameter.type);
      added.detail = type_symbol(parameter.type);
      found_.items.push_back(std::move(added));
    }
  }

  /// Of the binders that begin in front of the caret.
  void add_bound_names() {
    if (!inside_.valid()) return;
    const Definition& definition = snapshot_.definition(inside_);
    for (const BoundName& bound : definition.checked->bound) {
      const NameId name = snapshot_.names_of(caret_.block).by_node[bound.variable.value];
      const bool is_in_front = block_.tokens[block_.tree.node(bound.node).first_token].span.begin < caret_.offset;
      if (!name.valid() || !is_in_front || is_hidden(name)) continue;
      hidden_.push_back(name);
      if (!matches(snapshot_.names().text(name))) continue;
      CompletionItem added = item(CompletionKind::Parameter, snapshot_.names().text(name), bound.type);
      added.detail = type_symbol(bound.type);
      found_.items.push_back(std::move(added));
    }
  }

  void add_definitions() {
    if (inside_.valid()) {
      const Definition& definition = snapshot_.definition(inside_);
      hidden_.push_back(definition.name);  // nothing can be made of itself
    }
    index_.update(snapshot_.shared_names());
    const NameIndex::Matches known = index_.starting_with(key_, kMostExamined);
    found_.complete = known.complete;
    if (!known.complete) examine_near_definitions();
    for (const NameId name : known.names) {
      if (!known.complete && candidates_.size() >= kMostCompletions) break;
      examine(name);
    }
    if (candidates_.size() > kMostCompletions) {
      std::ranges::stable_sort(candidates_, {}, &Candidate::fit);
      candidates_.resize(kMostCompletions);
      found_.complete = false;
    }
    for (const Candidate& candidate : candidates_) add_definition(candidate.definition);
  }

  /// Outward from the caret's block.
  void examine_near_definitions() {
    const DefinitionRange here = snapshot_.definitions_of(caret_.block);
    const auto count = static_cast<uint32_t>(snapshot_.all_definitions().size());
    for (uint32_t distance = 0; distance < kFarthest; ++distance) {
      if (here.first.value > distance) examine_near(here.first.value - distance - 1);
      if (here.end.value + distance < count) examine_near(here.end.value + distance);
    }
  }

  void examine_near(uint32_t id) {
    const Definition& definition = snapshot_.definition(DefinitionId{id});
    if (!definition.in_force || !matches(snapshot_.names().text(definition.name)) || is_hidden(definition.name)) return;
    candidates_.push_back({DefinitionId{id}, fit_of(definition.checked->signature.result)});
    hidden_.push_back(definition.name);
  }

  void examine(NameId name) {
    if (is_hidden(name)) return;
    const auto id = snapshot_.find(name);
    if (!id) return;
    const Definition& definition = snapshot_.definition(*id);
    candidates_.push_back({*id, fit_of(definition.checked->signature.result)});
  }

  bool is_hidden(NameId name) const { return std::ranges::find(hidden_, name) != hidden_.end(); }

  void add_definition(DefinitionId id) {
    const Definition& definition = snapshot_.definition(id);
    const CheckedDefinition& checked = *definition.checked;
    const std::string_view name = snapshot_.names().text(definition.name);
    CompletionItem added = item(CompletionKind::Definition, name, checked.signature.result);
    added.detail = signature_text(checked.signature);
    added.is_function = checked.signature.is_function;
    if (added.is_function && options_.snippets && !is_called_already()) {
      added.is_snippet = true;
      added.new_text = call_snippet(added.label, parameter_names(checked));
    }
    found_.items.push_back(std::move(added));
  }

  std::vector<std::string_view> parameter_names(const CheckedDefinition& function) const {
    std::vector<std::string_view> names;
    for (const CheckedParameter& parameter : function.parameters) {
      names.push_back(parameter.name.valid() ? snapshot_.names().text(parameter.name) : std::string_view{});
    }
    return names;
  }

  void add_conventions() {
    for (const ConventionEntry& entry : conventions()) {
      const auto spelling = std::ranges::find_if(entry.spellings, [this](auto name) { return matches(name); });
      if (spelling == entry.spellings.end() || is_taken(entry.spellings.front())) continue;
      CompletionItem added = item(CompletionKind::Convention, *spelling, entry.type);
      added.detail = type_symbol(entry.type);
      found_.items.push_back(std::move(added));
    }
  }

  /// Upright, as LaTeX sets the names of functions.
  void add_builtins() {
    for (const BuiltinEntry& entry : builtin_functions()) {
      for (const std::string_view word : words_of(entry.spellings)) {
        const std::string name = fmt::format("\\text{{{}}}", word);
        const bool has_command = find_command(word) != Command::None;
        if (has_command || !matches(name) || is_taken(name) || is_taken(word)) continue;
        CompletionItem added = item(CompletionKind::Builtin, name, entry.signature.result);
        added.detail = signature_text(entry.signature);
        added.is_function = true;
        if (options_.snippets && !is_called_already()) {
          added.is_snippet = true;
          added.new_text = command_snippet(added.label, places_for(entry.signature));
        }
        found_.items.push_back(std::move(added));
      }
    }
  }

  void add_macros() {
    for (const DocumentMacro& macro : snapshot_.macros()) {
      const std::string spelling = fmt::format("\\{}", macro.name);
      if (!matches(spelling)) continue;
      macros_.push_back(spelling);
      std::string tail;
      for (uint32_t i = 0; i < macro.parameters; ++i) tail += "{#}";
      CompletionItem added = item(CompletionKind::Macro, spelling, Type::Error);
      added.fit = Fit::Good;
      added.detail = shortened(macro.body);
      if (options_.snippets && !tail.empty()) {
        added.is_snippet = true;
        added.label = command_label(spelling, tail);
        if (added.filter.empty()) added.filter = spelling;
        added.new_text = command_snippet(spelling, tail);
      }
      found_.items.push_back(std::move(added));
    }
  }

  /// By a definition or a parameter.
  bool is_taken(std::string_view convention) const {
    const NameId name = snapshot_.names().find(convention);
    if (!name.valid()) return false;
    return snapshot_.find(name) || is_hidden(name);
  }

  void add_commands() {
    for (const CompletionCommand& command : completion_commands()) {
      const bool fits_side = !caret_.is_left_side || command.role == CommandRole::Decoration;
      // Without its places to fill in, the literal is no more than \vec.
      const bool is_double = !options_.snippets && command.role == CommandRole::Value && command.spelling == "\\vec";
      if (!fits_side || is_double || !matches(command.spelling)) continue;
      if (std::ranges::find(macros_, command.spelling) != macros_.end()) continue;
      CompletionItem added = item(CompletionKind::Command, command.spelling, command.type);
      if (command.role == CommandRole::Layout) added.fit = Fit::Bad;
      if (options_.snippets && !command.tail.empty()) {
        added.is_snippet = true;
        added.label = command_label(command.spelling, command.tail);
        if (added.filter.empty()) added.filter = command.spelling;
        added.new_text = command_snippet(command.spelling, command.tail);
      }
      found_.items.push_back(std::move(added));
    }
  }

  void add_letters() {
    for (const std::string_view letter : greek_letters()) {
      const std::string spelling = fmt::format("\\{}", letter);
      if (matches(spelling)) found_.items.push_back(item(CompletionKind::Letter, spelling, Type::Error));
    }
  }

  /// A `(` follows: the arguments stand there.
  bool is_called_already() const {
    const auto behind =
        std::ranges::find_if(block_.tokens, [this](const Token& token) { return token.span.begin >= replaced_.end; });
    return behind != block_.tokens.end() && behind->kind == TokenKind::OpenParen;
  }

  const Snapshot& snapshot_;
  const Caret& caret_;
  const ParsedBlock& block_;
  NameIndex& index_;
  CompletionOptions options_;
  std::string_view typed_;
  std::string key_;
  Span replaced_;
  DefinitionId inside_;
  std::optional<Type> demanded_;
  std::vector<NameId> hidden_;       ///< not to be proposed as definitions
  std::vector<std::string> macros_;  ///< that are proposed
  std::vector<Candidate> candidates_;
  Completions found_;
};

std::string describe_parameter_named(const Snapshot& snapshot, std::string_view name, std::string_view function,
                                     Markup markup) {
  const auto id = snapshot.find(function);
  if (!id) return {};
  const Definition& definition = snapshot.definition(*id);
  const std::vector<CheckedParameter>& parameters = definition.checked->parameters;
  for (uint32_t i = 0; i < parameters.size(); ++i) {
    const bool is_meant = parameters[i].name.valid() && snapshot.names().text(parameters[i].name) == name;
    if (is_meant) return describe_parameter(snapshot, *id, i, markup);
  }
  return {};
}

std::string describe_macro_named(const Snapshot& snapshot, std::string_view label, Markup markup) {
  const std::string_view name = label.substr(1, label.find('{') - 1);
  const std::vector<Span> places = snapshot.places_of_macro(name);
  if (places.empty()) return {};
  for (const Span place : places) {
    if (!snapshot.is_in_file(place)) continue;
    const auto macro = snapshot.macro_at(place.begin);
    if (macro) return describe_macro(snapshot, *macro, markup);
  }
  return {};
}

std::string describe_command(std::string_view label, Markup markup) {
  for (const CompletionCommand& command : completion_commands()) {
    const bool is_meant = label == command.spelling || label == command_label(command.spelling, command.tail);
    if (!is_meant) continue;
    std::string text(command.documentation);
    if (markup == Markup::PlainText) std::erase(text, '`');
    return text;
  }
  return {};
}

}  // namespace

Completions complete(const Snapshot& snapshot, uint32_t offset, NameIndex& index, const CompletionOptions& options) {
  const auto caret = find_caret(snapshot, offset);
  if (!caret) return {};
  return Completer(snapshot, *caret, index, options).run();
}

std::string describe_completion(const Snapshot& snapshot, CompletionKind kind, std::string_view label,
                                std::string_view function, Markup markup) {
  switch (kind) {
    case CompletionKind::Parameter:
      return describe_parameter_named(snapshot, label, function, markup);
    case CompletionKind::Definition: {
      const auto id = snapshot.find(label);
      return id ? describe_definition(snapshot, *id, markup) : std::string{};
    }
    case CompletionKind::Convention: {
      const auto convention = find_convention(label);
      const auto inside = snapshot.find(function);
      if (!convention) return {};
      return describe_convention(snapshot, label, *convention, inside.value_or(DefinitionId{}), markup);
    }
    case CompletionKind::Macro:
      return describe_macro_named(snapshot, label, markup);
    case CompletionKind::Builtin: {
      const auto builtin = find_builtin(label);
      return builtin ? describe_builtin(label, *builtin, markup) : std::string{};
    }
    case CompletionKind::Command:
      return describe_command(label, markup);
    case CompletionKind::Letter:
      return {};
  }
  return {};
}

}  // namespace texbrdf::features
