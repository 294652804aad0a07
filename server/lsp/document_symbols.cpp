#include "features/document_symbols.h"

#include "lsp/session.h"
#include "lsp/text_walk.h"

namespace texbrdf::lsp {
namespace {

constexpr std::size_t kUsualSymbolBytes = 280;

int symbol_kind_number(features::SymbolKind kind) {
  constexpr int kFunction = 12;
  constexpr int kVariable = 13;
  constexpr int kTypeParameter = 26;
  switch (kind) {
    case features::SymbolKind::Function:
      return kFunction;
    case features::SymbolKind::Variable:
      return kVariable;
    case features::SymbolKind::Parameter:
      return kTypeParameter;
  }
  return kVariable;
}

Range range_of(TextWalk& walk, Span span) {
  const Position start = walk.at(span.begin);
  return {start, walk.at(span.end)};
}

void write_parameter(JsonWriter& out, const features::Symbol& parameter, Range range) {
  out.begin_object();
  out.member("name", parameter.name);
  out.member("detail", parameter.type);
  out.member("kind", symbol_kind_number(parameter.kind));
  write_range(out, "range", range);
  write_range(out, "selectionRange", range);
  out.end_object();
}

/// Writes DocumentSymbols. Each block's text is gone through once: asking the document for every position would cost
/// more than all the rest.
class SymbolWriter {
 public:
  SymbolWriter(JsonWriter& out, const Snapshot& snapshot, ColumnUnit unit)
      : out_(out), snapshot_(snapshot), unit_(unit), walk_({}, unit) {}

  void write(const features::Symbol& symbol) {
    if (symbol.block != block_) enter(symbol.block);
    Range whole;
    whole.start = walk_.at(symbol.whole.begin);
    const Range selection = range_of(walk_, symbol.selection);
    parameters_.clear();
    for (const features::Symbol& child : symbol.children) parameters_.push_back(range_of(walk_, child.whole));
    whole.end = walk_.at(symbol.whole.end);

    out_.begin_object();
    out_.member("name", symbol.name);
    out_.member("detail", symbol.type);
    out_.member("kind", symbol_kind_number(symbol.kind));
    write_range(out_, "range", whole);
    write_range(out_, "selectionRange", selection);
    if (!symbol.children.empty()) write_parameters(symbol);
    out_.end_object();
  }

 private:
  void enter(BlockId block) {
    block_ = block;
    const Position begin = snapshot_.text().position(snapshot_.absolute(block, {}).begin, unit_);
    walk_ = TextWalk(snapshot_.parsed(block).text, unit_, begin);
  }
  void write_parameters(const features::Symbol& symbol) {
    out_.key("children");
    out_.begin_array();
    for (std::size_t i = 0; i < parameters_.size(); ++i) write_parameter(out_, symbol.children[i], parameters_[i]);
    out_.end_array();
  }

  JsonWriter& out_;
  const Snapshot& snapshot_;
  ColumnUnit unit_;
  BlockId block_{UINT32_MAX};
  TextWalk walk_;  // of the block
  std::vector<Range> parameters_;
};

/// A SymbolInformation, for clients that know no hierarchy.
void write_flat_symbol(JsonWriter& out, const Snapshot& snapshot, Positions& positions, std::string_view uri,
                       const features::Symbol& symbol, std::string_view container) {
  out.begin_object();
  out.member("name", symbol.name);
  out.member("kind", symbol_kind_number(symbol.kind));
  out.key("location");
  write_location(out, positions, uri, snapshot.absolute(symbol.block, symbol.whole));
  if (!container.empty()) out.member("containerName", container);
  out.end_object();
}

void write_flat_symbols(JsonWriter& out, const Snapshot& snapshot, ColumnUnit unit, std::string_view uri,
                        std::span<const features::Symbol> symbols) {
  Positions positions(snapshot.text(), unit);
  for (const features::Symbol& symbol : symbols) {
    write_flat_symbol(out, snapshot, positions, uri, symbol, {});
    for (const features::Symbol& child : symbol.children) {
      write_flat_symbol(out, snapshot, positions, uri, child, symbol.name);
    }
  }
}

}  // namespace

Session::Outcome Session::document_symbol(const DocumentParams& params, JsonWriter& result) {
  OpenDocument* open = documents_.find(params.uri);
  if (open == nullptr) return not_open(params.uri);
  const Snapshot& snapshot = open->document.snapshot();
  const std::vector<features::Symbol> symbols = features::document_symbols(snapshot);
  result.reserve(symbols.size() * kUsualSymbolBytes);
  result.begin_array();
  if (client_.hierarchical_symbols) {
    SymbolWriter writer(result, snapshot, unit_);
    for (const features::Symbol& symbol : symbols) writer.write(symbol);
  } else {
    write_flat_symbols(result, snapshot, unit_, params.uri, symbols);
  }
  result.end_array();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
