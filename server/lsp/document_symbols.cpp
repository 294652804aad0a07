#include "features/document_symbols.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lsp/session.h"
#include "lsp/text_walk.h"
#include "source/position_walk.h"

namespace texbrdf::lsp {
namespace {

constexpr std::size_t kUsualSymbolBytes = 4096;

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

/// Writes the DocumentSymbols of one block, whose text is gone through once.
class BlockWriter {
 public:
  BlockWriter(JsonWriter& out, const ParsedBlock& block, ColumnUnit unit, Position begin)
      : out_(out), walk_(block.source(), unit, begin) {}

  void write(const features::Symbol& symbol) {
    Range whole;
    whole.start = walk_.at(symbol.whole.begin);
    const Range selection = range_of(walk_, symbol.selection);
    std::vector<Range> parameters;
    for (const features::Symbol& child : symbol.children) parameters.push_back(range_of(walk_, child.whole));
    whole.end = walk_.at(symbol.whole.end);

    out_.begin_object();
    out_.member("name", symbol.name);
    out_.member("detail", symbol.type);
    out_.member("kind", symbol_kind_number(symbol.kind));
    write_range(out_, "range", whole);
    write_range(out_, "selectionRange", selection);
    if (!symbol.children.empty()) write_parameters(symbol, parameters);
    out_.end_object();
  }

 private:
  void write_parameters(const features::Symbol& symbol, const std::vector<Range>& ranges) {
    out_.key("children");
    out_.begin_array();
    for (std::size_t i = 0; i < ranges.size(); ++i) write_parameter(out_, symbol.children[i], ranges[i]);
    out_.end_array();
  }

  JsonWriter& out_;
  TextWalk walk_;
};

/// With a comma behind.
std::string block_json(const Snapshot& snapshot, BlockId id, ColumnUnit unit, Position begin) {
  JsonWriter out;
  BlockWriter writer(out, snapshot.parsed(id), unit, begin);
  for (const features::Symbol& symbol : features::block_symbols(snapshot, id)) writer.write(symbol);
  std::string symbols = out.take();
  if (!symbols.empty()) symbols += ',';
  return symbols;
}

/// Writes all symbols; what was written before of blocks that are as they were, and where they were, is taken over.
class SymbolWriter {
 public:
  SymbolWriter(const Snapshot& snapshot, ColumnUnit unit, SymbolCache& cache)
      : snapshot_(snapshot), unit_(unit), cache_(cache), positions_(snapshot.text(), unit) {}

  void run() {
    now_.runs.reserve(snapshot_.blocks().size());
    uint32_t index = 0;
    for (const Block& block : snapshot_.blocks()) write(BlockId{index++}, block);
    take_over();
    now_.snapshot = snapshot_;
    cache_ = std::move(now_);
  }

 private:
  void write(BlockId id, const Block& block) {
    const Position begin = positions_.at(block.offset);
    const SymbolCache::Run* const before = find_run(block.identity, begin);
    if (before != nullptr) {
      if (before->offset != same_.end) take_over();
      if (same_.empty()) same_.begin = before->offset;
      same_.end = before->offset + before->size;
      now_.runs.push_back({block.identity, begin, json_size() - before->size, before->size});
      return;
    }
    take_over();
    const std::string symbols = block_json(snapshot_, id, unit_, begin);
    now_.runs.push_back({block.identity, begin, json_size(), static_cast<uint32_t>(symbols.size())});
    now_.json += symbols;
  }

  uint32_t json_size() const { return static_cast<uint32_t>(now_.json.size()) + same_.size(); }

  void take_over() {
    if (same_.empty()) return;
    if (same_.size() == cache_.json.size()) {
      now_.json = std::move(cache_.json);
    } else {
      if (now_.json.empty()) now_.json.reserve(cache_.json.size() + kUsualSymbolBytes);
      now_.json.append(cache_.json, same_.begin, same_.size());
    }
    same_ = {};
  }

  // Blocks keep their order: the next one is found at once or soon.
  const SymbolCache::Run* find_run(const void* block, Position begin) {
    constexpr std::size_t kFar = 8;
    for (std::size_t i = next_; i < std::min(next_ + kFar, cache_.runs.size()); ++i) {
      if (cache_.runs[i].block != block) continue;
      next_ = i + 1;
      return cache_.runs[i].begin == begin ? &cache_.runs[i] : nullptr;
    }
    ++next_;
    return nullptr;
  }

  const Snapshot& snapshot_;
  ColumnUnit unit_;
  SymbolCache& cache_;  // of the answer before
  std::size_t next_ = 0;
  Span same_;  // of the old text: taken over, not yet written
  SymbolCache now_;
  PositionWalk positions_;
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
  result.begin_array();
  if (client_.hierarchical_symbols) {
    SymbolWriter(snapshot, unit_, open->symbols).run();
    const std::string_view symbols = open->symbols.json;
    result.reserve(symbols.size());
    if (!symbols.empty()) result.raw(symbols.substr(0, symbols.size() - 1));  // without the last comma
  } else {
    write_flat_symbols(result, snapshot, unit_, params.uri, features::document_symbols(snapshot));
  }
  result.end_array();
  return std::nullopt;
}

}  // namespace texbrdf::lsp
