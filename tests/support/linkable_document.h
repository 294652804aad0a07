#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "ir/lower.h"
#include "ir/program.h"
#include "semantics/background.h"
#include "semantics/dependency_order.h"
#include "semantics/implied_mentions.h"
#include "semantics/implied_parameters.h"
#include "semantics/instance_facts.h"
#include "semantics/parameter.h"
#include "support/settled_block.h"
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
    settle();
    for (const ParsedBlock& block : blocks_) {
      const BlockNames names = read_names(block, table_);
      for (const DefinitionSyntax& definition : block.definitions) {
        if (!is_background(block, definition, names, table_)) add({&block, &definition, names});
      }
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
    return [this](const Instance& instance) -> const ir::LinkableDefinition* {
      const auto found = definitions_.find(instance);
      return found == definitions_.end() ? nullptr : &found->second;
    };
  }

  NameId name(std::string_view canonical) const { return table_.find(canonical); }
  const ir::LinkableDefinition& definition(std::string_view canonical) const {
    return definitions_.at({name(canonical), {}});
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

  class StatedNames final : public KnownNames {
   public:
    NameKind kind(NameId name) const override {
      const auto found = known.find(name);
      return found == known.end() ? NameKind::Absent : found->second.first;
    }
    std::span<const NameId> parameters(NameId function) const override { return known.at(function).second; }
    std::map<NameId, std::pair<NameKind, std::vector<NameId>>> known;
  };

  void settle() {
    for (const ParsedBlock& block : blocks_) {
      const BlockNames names = read_names(block, table_);
      for (const DefinitionSyntax& definition : block.definitions) {
        if (is_background(block, definition, names, table_)) continue;
        const bool is_function = definition.left != definition.name;
        stated_.known.emplace(
            names.by_node[definition.name.value],
            std::pair{is_function ? NameKind::Function : NameKind::Value, parameter_names(block, definition, names)});
      }
    }
    for (ParsedBlock& block : blocks_) block = settled_block(block, table_, stated_);
  }

  class KnownSignatures final : public InstanceFacts {
   public:
    explicit KnownSignatures(const LinkableDocument& document) : document_(document) {}
    const NameFact& fact(NameId name) const override {
      const auto found = known.find(name);
      if (found != known.end()) return found->second;
      return document_.is_parameter(name) ? absent_parameter_ : absent_;
    }
    std::map<NameId, NameFact> known;

   private:
    std::optional<DefinitionView> definition(NameId function) const override {
      const auto found = document_.by_name_.find(function);
      if (found == document_.by_name_.end()) return std::nullopt;
      const Source& source = document_.sources_[found->second];
      return DefinitionView{*source.block, *source.syntax, source.names, document_.table_, *this};
    }
    InstancesOfFunction& known_instances(NameId function) const override { return instances_[function]; }

    const LinkableDocument& document_;
    NameFact absent_;
    NameFact absent_parameter_ = [] {
      NameFact fact;
      fact.is_parameter = true;
      return fact;
    }();
    mutable std::map<NameId, InstancesOfFunction> instances_;
  };

  bool is_parameter(NameId name) const {
    return std::ranges::any_of(stated_.known, [&](const auto& stated) {
      return std::ranges::find(stated.second.second, name) != stated.second.second.end();
    });
  }

  void add(Source source) {
    by_name_.emplace(source.name(), static_cast<uint32_t>(sources_.size()));
    sources_.push_back(std::move(source));
  }

  std::vector<uint32_t> mentioned(const Source& source) {
    std::vector<uint32_t> indices;
    SmallNameMap names = mentioned_names(*source.block, *source.syntax, source.names);
    for (const NameId name : implied_mentions(*source.block, *source.syntax, source.names, table_, stated_)) {
      names.insert(name);
    }
    for (const NameId name : names.names()) {
      if (const auto found = by_name_.find(name); found != by_name_.end()) indices.push_back(found->second);
    }
    return indices;
  }

  void lower(const Source& source) {
    const ParsedBlock& block = *source.block;
    const CheckedDefinition checked = check_definition(block, *source.syntax, source.names, table_, facts_);
    if (!checked.sound) throw std::runtime_error("in error: " + std::string(block.text));
    NameFact& fact = facts_.known[source.name()];
    fact.kind = NameFact::Kind::Defined;
    fact.signature = checked.signature;
    fact.parameters = checked.signature.has_implied_parameters ? names_of_parameters(checked)
                                                               : parameter_names(block, *source.syntax, source.names);
    add_definition({source.name(), {}}, source, checked);
  }

  void add_definition(const Instance& instance, const Source& source, const CheckedDefinition& checked) {
    const ParsedBlock& block = *source.block;
    for (const InstanceCall& call : checked.instance_calls) {
      if (definitions_.contains(call.instance)) continue;
      const Source& callee = sources_[by_name_.at(call.instance.function)];
      add_definition(
          call.instance, callee,
          check_instance(*callee.block, *callee.syntax, callee.names, table_, facts_, call.instance.parameters));
    }
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
      const std::string_view text = parameter.name.valid() ? table_.text(parameter.name) : "argument";
      definition.formals.push_back(*name_spelled(text));
    }
    definitions_.emplace(instance, std::move(definition));
  }

  NameTable table_;
  StatedNames stated_;
  std::vector<ParsedBlock> blocks_;
  std::vector<Source> sources_;
  std::map<NameId, uint32_t> by_name_;
  KnownSignatures facts_{*this};
  std::map<Instance, ir::LinkableDefinition> definitions_;
};

}  // namespace texbrdf::test
