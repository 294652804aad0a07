#pragma once

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ir/lower.h"
#include "ir/program.h"
#include "semantics/dependency_order.h"
#include "semantics/factors.h"
#include "semantics/parameter.h"
#include "syntax/block_scanner.h"

namespace texbrdf::test {

/// The definitions of a document as the linker takes them: scanned, parsed, checked and lowered without the layers
/// above ir. Throws where one is in error.
class LinkableDocument {
 public:
  explicit LinkableDocument(std::string_view text) {
    for (const BlockExtent& extent : scan_blocks(text)) {
      blocks_.push_back(parse_block(text.substr(extent.whole.begin, extent.whole.size()), extent));
    }
    read_factors();
    for (const ParsedBlock& block : blocks_) {
      const BlockNames names = read_names(block, table_);
      for (const DefinitionSyntax& definition : block.definitions) add({&block, &definition, names});
    }
    AdjacencyLists edges;
    for (const Source& source : sources_) {
      const std::vector<uint32_t> targets = mentioned(source);
      edges.targets.insert(edges.targets.end(), targets.begin(), targets.end());
      edges.close_list();
    }
    for (const uint32_t index : dependency_order(edges).order) lower(sources_[index]);
  }

  ir::DefinitionLookup lookup() const {
    return [this](NameId name) {
      const auto found = definitions_.find(name);
      return found == definitions_.end() ? nullptr : &found->second;
    };
  }

  NameId name(std::string_view canonical) const { return table_.find(canonical); }
  const ir::LinkableDefinition& definition(std::string_view canonical) const {
    return definitions_.at(name(canonical));
  }

  Result<ir::Program> link(std::string_view root = "f", const ir::LinkOptions& options = {}) const {
    return ir::link(lookup(), name(root), options);
  }

 private:
  struct Source {
    const ParsedBlock* block;
    const DefinitionSyntax* syntax;
    BlockNames names;
    NameId name() const { return names.by_node[syntax->name.value]; }
  };

  void read_factors() {
    std::map<NameId, NameKind> kinds;
    for (const ParsedBlock& block : blocks_) {
      const BlockNames names = read_names(block, table_);
      for (const DefinitionSyntax& definition : block.definitions) {
        const bool is_function = definition.left != definition.name;
        kinds.emplace(names.by_node[definition.name.value], is_function ? NameKind::Function : NameKind::Value);
      }
    }
    const auto kind_of = [&](NameId name) { return kinds.contains(name) ? kinds.at(name) : NameKind::Absent; };
    for (ParsedBlock& block : blocks_) {
      const std::vector<uint32_t> factors = find_factors(block, read_names(block, table_), table_, kind_of);
      if (factors.empty()) continue;
      const std::string text(block.text);
      block = parse_block(text, block.extent, std::pmr::get_default_resource(), factors);
    }
  }

  class KnownSignatures final : public Facts {
   public:
    const NameFact& fact(NameId name) const override {
      const auto found = known.find(name);
      return found == known.end() ? absent_ : found->second;
    }
    std::map<NameId, NameFact> known;

   private:
    NameFact absent_;
  };

  void add(Source source) {
    by_name_.emplace(source.name(), static_cast<uint32_t>(sources_.size()));
    sources_.push_back(std::move(source));
  }

  std::vector<uint32_t> mentioned(const Source& source) const {
    std::vector<uint32_t> indices;
    const SmallNameMap names = mentioned_names(*source.block, *source.syntax, source.names);
    for (const NameId name : names.names()) {
      if (const auto found = by_name_.find(name); found != by_name_.end()) indices.push_back(found->second);
    }
    return indices;
  }

  void lower(const Source& source) {
    const ParsedBlock& block = *source.block;
    const CheckedDefinition checked = check_definition(block, *source.syntax, source.names, table_, facts_);
    if (!checked.sound) throw std::runtime_error("in error: " + std::string(block.text));
    facts_.known[source.name()] = {.kind = NameFact::Kind::Defined, .signature = checked.signature};
    std::vector<Diagnostic> ignored;
    ir::LinkableDefinition definition{.id = source.name(),
                                      .name = read_name(block, source.syntax->name),
                                      .canonical = std::string(table_.text(source.name())),
                                      .signature = checked.signature,
                                      .formals = {},
                                      .graph = ir::lower_definition(block, *source.syntax, source.names, checked),
                                      .literal = parameter_literal(block, *source.syntax, ignored),
                                      .equation = std::string(block.node_text(source.syntax->node))};
    for (const CheckedParameter& parameter : checked.parameters) {
      definition.formals.push_back(read_name(block, parameter.node));
    }
    definitions_.emplace(source.name(), std::move(definition));
  }

  NameTable table_;
  std::vector<ParsedBlock> blocks_;
  std::vector<Source> sources_;
  std::map<NameId, uint32_t> by_name_;
  KnownSignatures facts_;
  std::map<NameId, ir::LinkableDefinition> definitions_;
};

}  // namespace texbrdf::test
