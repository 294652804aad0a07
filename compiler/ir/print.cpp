#include "ir/print.h"

#include <fmt/format.h>

#include <iterator>

namespace texbrdf::ir {

namespace {

/// What an Index payload is shown as.
std::string index_text(const Value& value) {
  const Op op = value.op;
  if (op == Op::Convention) return std::string(convention_entry(static_cast<Convention>(value.index)).symbol);
  if (op == Op::Reference || op == Op::Call) return fmt::format("@{}", value.index);
  if (op == Op::BoundVariable || binds(op)) return fmt::format("k{}", value.index);
  return fmt::format("{}", value.index);
}

std::string payload_text(const Value& value) {
  switch (op_entry(value.op).payload) {
    case Payload::None:
      return "";
    case Payload::Constant:
      return fmt::format(" {}", value.constant);
    case Payload::Index:
      return " " + index_text(value);
  }
  return "";
}

void print_values(std::string& out, const Graph& graph, std::string_view indent) {
  for (uint32_t i = 0; i < graph.size(); ++i) {
    const Value& value = graph.at({i});
    fmt::format_to(std::back_inserter(out), "{}%{}: {} = {}{}", indent, i, type_symbol(value.type),
                   op_entry(value.op).printed, payload_text(value));
    for (const ValueId operand : graph.operands({i})) out += fmt::format(" %{}", operand.value);
    out += '\n';
  }
  out += indent;
  out += "roots";
  for (const ValueId root : graph.roots) out += fmt::format(" %{}", root.value);
  out += '\n';
}

std::string numbers(const Parameter& parameter) {
  const auto& v = parameter.value;
  return parameter.type == Type::Real ? fmt::format("{}", v[0]) : fmt::format("({}, {}, {})", v[0], v[1], v[2]);
}

}  // namespace

std::string print_graph(const Graph& graph) {
  std::string out;
  print_values(out, graph, "");
  return out;
}

std::string print_program(const Program& program) {
  std::string out;
  for (std::size_t i = 0; i < program.parameters.size(); ++i) {
    const Parameter& p = program.parameters[i];
    out += fmt::format("parameter {} {}: {} = {} in [{}, {}]\n", i, p.canonical, type_symbol(p.type), numbers(p),
                       p.minimum, p.maximum);
  }
  for (std::size_t i = 0; i < program.definitions.size(); ++i) {
    const ProgramDefinition& d = program.definitions[i];
    out += fmt::format("definition @{} {}: {}\n", i, d.canonical, signature_text(d.signature));
    print_values(out, d.graph, "  ");
  }
  return out;
}

}  // namespace texbrdf::ir
