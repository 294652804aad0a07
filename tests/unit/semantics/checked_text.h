#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "semantics/check.h"
#include "semantics/implied_mentions.h"
#include "semantics/instance_facts.h"
#include "support/settled_block.h"
#include "syntax/block_scanner.h"

namespace texbrdf::test {

/// The definitions of equations, given without \begin and \end, each checked after those before it. Says what the
/// checker alone says: nothing that needs the whole document.
class CheckedText {
 public:
  explicit CheckedText(const std::vector<std::string>& equations) {
    for (const std::string& equation : equations) add(equation);
  }

  const CheckedDefinition& last() const { return checked_.back(); }
  const ParsedBlock& block() const { return *blocks_.back(); }
  const NameTable& names() const { return table_; }

  /// "code [underlined]: message" of the last definition, hints and all.
  std::vector<std::string> reports() const {
    std::vector<std::string> lines;
    for (const Diagnostic& d : last().diagnostics) {
      lines.push_back(code_name(d.code) + " [" + std::string(block().slice(d.where.span)) + "] " + message(d));
    }
    return lines;
  }

 private:
  class Known final : public InstanceFacts, public KnownNames {
   public:
    explicit Known(const CheckedText& text) : text_(text) {}
    const NameFact& fact(NameId name) const override {
      static const NameFact absent;
      return name.value < facts.size() ? facts[name.value] : absent;
    }
    NameKind kind(NameId name) const override {
      if (fact(name).kind == NameFact::Kind::Absent) return NameKind::Absent;
      return fact(name).signature.is_function ? NameKind::Function : NameKind::Value;
    }
    std::span<const NameId> parameters(NameId function) const override { return fact(function).parameters; }
    std::vector<NameFact> facts;

   private:
    std::optional<DefinitionView> definition(NameId function) const override {
      for (size_t i = 0; i < text_.checked_.size(); ++i) {
        if (text_.checked_[i].name != function) continue;
        const ParsedBlock& block = *text_.blocks_[i];
        return DefinitionView{block, block.definitions.at(0), text_.names_[i], text_.table_, *this};
      }
      return std::nullopt;
    }
    InstancesOfFunction& known_instances(NameId function) const override { return instances_[function]; }

    const CheckedText& text_;
    mutable std::map<NameId, InstancesOfFunction> instances_;
  };

  void add(const std::string& equation) {
    const std::string text = "\\begin{equation}" + equation + "\n\\end{equation}";
    const BlockExtent extent = scan_blocks(text).at(0);
    blocks_.push_back(std::make_unique<ParsedBlock>(settled_block(parse_block(text, extent), table_, known_)));
    const ParsedBlock& block = *blocks_.back();
    const DefinitionSyntax& definition = block.definitions.at(0);
    const BlockNames& names = names_.emplace_back(read_names(block, table_));
    implied_mentions(block, definition, names, table_, known_);  // which the table has to know
    known_.facts.resize(table_.size());
    checked_.push_back(check_definition(block, definition, names, table_, known_));
    known_.facts[checked_.back().name.value] = {NameFact::Kind::Defined, checked_.back().signature,
                                                parameter_names(block, definition, names)};
  }

  NameTable table_;
  std::vector<std::unique_ptr<ParsedBlock>> blocks_;
  std::deque<BlockNames> names_;
  std::vector<CheckedDefinition> checked_;
  Known known_{*this};
};

}  // namespace texbrdf::test
