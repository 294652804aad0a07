#include "ir/link_entries.h"

#include <algorithm>
#include <string>

#include "ir/passes/passes.h"

namespace texbrdf::ir {
namespace {

class EntryLinker {
 public:
  EntryLinker(const Graph& graph, const std::function<LinkTarget(const Instance&)>& target)
      : source_(graph), target_(target), images_(graph.size()) {}

  std::vector<Graph> run() {
    for (uint32_t i = 0; i < source_.size(); ++i) {
      if (!is_aggregate(source_.at({i}).type)) images_[i] = image({i});
    }
    const ValueId root = source_.roots[0];
    const Type type = source_.at(root).type;
    if (!is_aggregate(type)) {
      result_.roots = {images_[root.value]};
      return {with_what_is_needed()};
    }
    std::vector<ValueId> entries;
    for (uint32_t i = 0; i < type_components(type); ++i) entries.push_back(entry(root, i));
    std::vector<Graph> graphs;
    for (const ValueId id : entries) {
      result_.roots = {id};
      graphs.push_back(with_what_is_needed());
    }
    return graphs;
  }

 private:
  ValueId image(ValueId id) {
    const Value& value = source_.at(id);
    if (value.op == Op::Entry) return entry(source_.operand(id, 0), value.index);
    return linked(id, 0);
  }

  ValueId entry(ValueId aggregate, uint32_t index) {
    const bool is_written = source_.at(aggregate).op == Op::MakeMatrix;
    return is_written ? images_[source_.operand(aggregate, index).value] : linked(aggregate, index);
  }

  /// Of a use of an aggregate the entry.
  ValueId linked(ValueId id, uint32_t entry) {
    Value value = source_.at(id);
    if (value.op == Op::Reference || value.op == Op::Call) {
      const LinkTarget target = target_(used(source_, value));
      if (target.op == Op::Parameter) value.op = Op::Parameter;
      value.index = target.index + entry;
      if (is_aggregate(value.type)) value.type = Type::Real;
    }
    std::vector<ValueId> operands;
    for (const ValueId operand : source_.operands(id)) operands.push_back(images_[operand.value]);
    return result_.copy(value, operands);
  }

  /// Where there are matrices, most of what they are made of is not.
  Graph with_what_is_needed() const {
    const auto is_matrix = [](const Value& value) { return is_aggregate(value.type); };
    return std::ranges::any_of(source_.values(), is_matrix) ? remove_dead_values(result_) : result_;
  }

  const Graph& source_;
  const std::function<LinkTarget(const Instance&)>& target_;
  Graph result_;
  std::vector<ValueId> images_;
};

}  // namespace

std::vector<Graph> link_entries(const Graph& graph, const std::function<LinkTarget(const Instance&)>& target) {
  return EntryLinker(graph, target).run();
}

Instance used(const Graph& graph, const Value& value) {
  if (value.index < kFirstInstance) return {NameId{value.index}, {}};
  return graph.instances[value.index - kFirstInstance];
}

ProgramDefinition program_definition(const LinkableDefinition& definition) {
  ProgramDefinition made{.id = definition.id,
                         .name = definition.name,
                         .canonical = definition.canonical,
                         .signature = definition.signature,
                         .formals = {},
                         .graph = {},
                         .equation = definition.equation};
  made.signature.parameters.clear();
  for (size_t i = 0; i < definition.formals.size(); ++i) {
    const Type type = definition.signature.parameters[i];
    const uint32_t count = is_aggregate(type) ? type_components(type) : 1;
    const Type entry = is_aggregate(type) ? Type::Real : type;
    made.signature.parameters.insert(made.signature.parameters.end(), count, entry);
    for (uint32_t k = 0; k < count; ++k) {
      const Name& formal = definition.formals[i];
      made.formals.push_back(is_aggregate(type) ? entry_name(formal, type_shape(type), k) : formal);
    }
  }
  return made;
}

Name entry_name(const Name& name, Shape shape, uint32_t index) {
  const std::string row = std::to_string(index / shape.columns + 1);
  const std::string column = std::to_string(index % shape.columns + 1);
  Name entry = name;
  entry.subscripts.push_back(shape.is_vector() ? std::to_string(index + 1) : row + column);
  return entry;
}

}  // namespace texbrdf::ir
