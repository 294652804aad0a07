#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "semantics/check.h"
#include "semantics/factors.h"
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
  class Known final : public Facts {
   public:
    const NameFact& fact(NameId name) const override {
      static const NameFact absent;
      return name.value < facts.size() ? facts[name.value] : absent;
    }
    std::vector<NameFact> facts;
  };

  static NameKind kind_of(const NameFact& fact) {
    if (fact.kind == NameFact::Kind::Absent) return NameKind::Absent;
    return fact.signature.is_function ? NameKind::Function : NameKind::Value;
  }

  void add(const std::string& equation) {
    const std::string text = "\\begin{equation}" + equation + "\n\\end{equation}";
    const BlockExtent extent = scan_blocks(text).at(0);
    const ParsedBlock first = parse_block(text, extent);
    const BlockNames first_names = read_names(first, table_);
    known_.facts.resize(table_.size());
    const std::vector<uint32_t> factors =
        find_factors(first, first_names, table_, [this](NameId name) { return kind_of(known_.fact(name)); });
    blocks_.push_back(
        std::make_unique<ParsedBlock>(parse_block(text, extent, std::pmr::get_default_resource(), factors)));
    const ParsedBlock& block = *blocks_.back();
    const BlockNames names = read_names(block, table_);
    checked_.push_back(check_definition(block, block.definitions.at(0), names, table_, known_));
    known_.facts[checked_.back().name.value] = {NameFact::Kind::Defined, checked_.back().signature};
  }

  NameTable table_;
  std::vector<std::unique_ptr<ParsedBlock>> blocks_;
  std::vector<CheckedDefinition> checked_;
  Known known_;
};

}  // namespace texbrdf::test
