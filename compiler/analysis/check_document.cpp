#include "analysis/check_document.h"

namespace texbrdf {
namespace {

class FactTable final : public Facts {
 public:
  explicit FactTable(const std::vector<NameFact>& facts) : facts_(facts) {}
  const NameFact& fact(NameId name) const override { return facts_[name.value]; }

 private:
  const std::vector<NameFact>& facts_;
};

const NameFact kAbsent;

class DocumentCheck {
 public:
  DocumentCheck(const std::vector<PlacedBlock>& blocks, const DefinitionList& list, const NameTable& table,
                const EarlierDocument* earlier)
      : blocks_(blocks), list_(list), table_(table), earlier_(earlier) {}

  CheckedDocument run() {
    result_.facts.resize(table_.size());
    result_.records.resize(list_.definitions.size());
    is_changed_.resize(table_.size());
    note_absent_names();
    for (const std::vector<uint32_t>& knot : list_.order.knots) poison(knot);
    for (uint32_t index : list_.order.order) check(index);
    return std::move(result_);
  }

 private:
  const AnalysedBlock& block_of(const ListedDefinition& definition) const { return *blocks_[definition.block].block; }

  const NameFact& earlier_fact(NameId name) const {
    const bool is_known = earlier_ != nullptr && name.value < earlier_->checked.facts.size();
    return is_known ? earlier_->checked.facts[name.value] : kAbsent;
  }

  void note_absent_names() {
    for (uint32_t name = 0; name < table_.size(); ++name) {
      if (list_.in_force[name] != kNoDefinition) continue;
      is_changed_[name] = earlier_fact(NameId{name}).kind != NameFact::Kind::Absent;
    }
  }

  void answer(NameId name, Signature signature) {
    NameFact& fact = result_.facts[name.value];
    fact = {NameFact::Kind::Defined, std::move(signature)};
    is_changed_[name.value] = fact != earlier_fact(name);
  }

  // Definitions on a cycle have no types; what they take is known all the same.
  void poison(const std::vector<uint32_t>& knot) {
    for (uint32_t index : knot) {
      const ListedDefinition& definition = list_.definitions[index];
      const ParsedBlock& block = block_of(definition).parsed;
      const Node& left = block.tree.node(block.definitions[definition.index_in_block].left);
      Signature signature;
      signature.is_function = left.kind == NodeKind::Signature;
      if (signature.is_function) signature.parameters.assign(left.child_count - 1, Type::Error);
      answer(definition.name, std::move(signature));
    }
  }

  void check(uint32_t index) {
    const ListedDefinition& definition = list_.definitions[index];
    result_.records[index] = earlier_record(definition);
    if (!result_.records[index]) result_.records[index] = check_anew(definition);
    const bool is_answered = result_.facts[definition.name.value].kind == NameFact::Kind::Defined;
    if (list_.find(definition.name) != index || is_answered) return;
    answer(definition.name, result_.records[index]->checked.signature);
  }

  std::shared_ptr<const DefinitionRecord> earlier_record(const ListedDefinition& definition) const {
    const uint32_t old_block = blocks_[definition.block].old_index;
    if (earlier_ == nullptr || old_block == UINT32_MAX) return nullptr;
    for (NameId name : block_of(definition).mentions_of(definition.index_in_block)) {
      if (is_changed_[name.value]) return nullptr;
    }
    const uint32_t first = old_block == 0 ? 0 : earlier_->list.block_ends[old_block - 1];
    return earlier_->checked.records[first + definition.index_in_block];
  }

  std::shared_ptr<const DefinitionRecord> check_anew(const ListedDefinition& definition) {
    ++result_.checked;
    const AnalysedBlock& block = block_of(definition);
    const FactTable facts(result_.facts);
    return std::make_shared<const DefinitionRecord>(check_definition(
        block.parsed, block.parsed.definitions[definition.index_in_block], block.names, table_, facts));
  }

  const std::vector<PlacedBlock>& blocks_;
  const DefinitionList& list_;
  const NameTable& table_;
  const EarlierDocument* earlier_;
  CheckedDocument result_;
  std::vector<bool> is_changed_;  // by NameId: has another fact than before the edit
};

}  // namespace

CheckedDocument check_document(const std::vector<PlacedBlock>& blocks, const DefinitionList& list,
                               const NameTable& table, const EarlierDocument* earlier) {
  return DocumentCheck(blocks, list, table, earlier).run();
}

}  // namespace texbrdf
