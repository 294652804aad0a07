#pragma once

#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "ir/graph.h"

namespace texbrdf::test {

/// Reads what ir::print_graph writes, so that tests can say graphs as text. Ids may be any words that begin with %.
/// Does not validate: broken graphs can be said too.
class GraphReader {
 public:
  explicit GraphReader(const std::string& text) : text_(text) {}

  ir::Graph read() {
    std::istringstream lines(text_);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string first;
      if (!(words >> first)) continue;
      if (first == "roots") {
        graph_.roots = operands(words);
      } else {
        read_value(first, words);
      }
    }
    return std::move(graph_);
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw std::runtime_error("graph text: " + what); }

  static Type type(const std::string& symbol) {
    for (Type type : {Type::Real, Type::Vector, Type::Colour, Type::Tuple, Type::Boolean, Type::Error}) {
      if (type_symbol(type) == symbol) return type;
    }
    fail("type " + symbol);
  }

  static const ir::OpEntry& entry(const std::string& printed) {
    constexpr auto kLast = static_cast<uint32_t>(ir::Op::Tanh);
    for (uint32_t i = 0; i <= kLast; ++i) {
      const ir::OpEntry& candidate = ir::op_entry(static_cast<ir::Op>(i));
      if (candidate.printed == printed) return candidate;
    }
    fail("op " + printed);
  }

  static uint32_t index(const std::string& word) {
    for (const ConventionEntry& convention : conventions()) {
      if (convention.symbol == word) return static_cast<uint32_t>(convention.id);
    }
    const std::size_t digits = word.find_first_of("0123456789");
    if (digits == std::string::npos) fail("index " + word);
    return static_cast<uint32_t>(std::stoul(word.substr(digits)));
  }

  /// An unknown id is taken as its number, as in a graph that is broken on purpose.
  std::vector<ir::ValueId> operands(std::istringstream& words) {
    std::vector<ir::ValueId> result;
    for (std::string word; words >> word;) {
      const auto known = ids_.find(word);
      result.push_back(known != ids_.end() ? known->second : ir::ValueId{index(word)});
    }
    return result;
  }

  void read_value(const std::string& id, std::istringstream& words) {
    std::string type_name, equals, printed, payload;
    words >> type_name >> equals >> printed;
    const ir::OpEntry& op = entry(printed);
    ir::Value value{.op = op.op, .type = type(type_name)};
    if (op.payload != ir::Payload::None) words >> payload;
    if (op.payload == ir::Payload::Constant) value.constant = std::stod(payload);
    if (op.payload == ir::Payload::Index) value.index = index(payload);
    ids_[id.substr(0, id.find(':'))] = graph_.copy(value, operands(words));
  }

  std::string text_;
  ir::Graph graph_;
  std::map<std::string, ir::ValueId> ids_;
};

inline ir::Graph read_graph(const std::string& text) {
  return GraphReader(text).read();
}

}  // namespace texbrdf::test
