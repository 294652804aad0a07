#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "ir/program.h"
#include "semantics/check.h"
#include "semantics/names.h"
#include "source/result.h"
#include "source/source_text.h"
#include "source/text_language.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// Work done for a snapshot; tests and `texbrdf/stats` read it.
struct Counters {
  uint64_t blocks_scanned = 0;
  uint64_t blocks_parsed = 0;
  uint64_t definitions_checked = 0;
};

/// Index of a definition in document order, over all blocks.
struct DefinitionId {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const DefinitionId&, const DefinitionId&) = default;
};

/// A block of the document with all that is known of it alone.
struct Block {
  uint32_t offset = 0;  ///< absolute, of its first byte
  std::shared_ptr<const ParsedBlock> parsed;
  std::shared_ptr<const BlockNames> names;
  /// As long as two snapshots live, equal in both exactly where the block and all that was found out about it are the
  /// same.
  const void* identity = nullptr;
};

/// A place in one of a project's files.
struct FilePlace {
  FileId file;
  Span span;  ///< of the file's text
};

/// The block of a place in prose, whose span is absolute.
inline constexpr BlockId kProse{UINT32_MAX};

/// The definitions of one block: [first, end).
struct DefinitionRange {
  DefinitionId first;
  DefinitionId end;
};

struct Definition {
  BlockId block;
  uint32_t index_in_block = 0;
  NameId name;
  bool in_force = true;  ///< false for a later definition of a name
  bool is_used = false;  ///< it is in force, and something mentions its name
  std::shared_ptr<const CheckedDefinition> checked;
};

/// What stands at a place of the document: a name and what it refers to.
struct Occurrence {
  Span span;  ///< absolute
  NodeId node;
  BlockId block;
  NameId name;
  DefinitionId inside;         ///< the definition in which it stands
  Referent referent;           ///< Parameter and Convention refer as in check.h; Definition: see `target`
  DefinitionId target;         ///< for a definition's name or a reference to one
  bool is_definition = false;  ///< it stands on the left side (the defined name, or a parameter's declaration)
  bool is_made = false;        ///< a macro made it: `span` is that of its use
};

/// NAME of a comment `% texbrdf: root = NAME`.
struct RootDirective {
  std::string name;  ///< canonical
  Span span;         ///< absolute
};

/// What a definition in force says of its name once more: `c` of `a = b = c`.
struct RestatedDefinition {
  DefinitionId definition;
  NodeId body;
};

/// It as if it were the definition.
struct CheckedRestatement {
  DefinitionSyntax syntax;
  CheckedDefinition checked;
  std::vector<NameId> asked;  ///< the names whose signatures were looked at
};

/// What a macro of the document stands for, wherever it is used.
struct DocumentMacro {
  std::string name;         ///< without the backslash
  uint32_t parameters = 0;  ///< those that have to be written
  std::string body;
};

/// A macro at a place of the document. Spans are absolute.
struct MacroOccurrence {
  std::string name;  ///< without the backslash
  Span span;         ///< of `\x`
  Span whole;        ///< with its arguments
  Span definition;   ///< the one that is in force
  Span definition_name;
};

class Snapshot;

/// The blocks or the definitions of a Snapshot in document order, given out one by one.
template <typename Value, typename Id>
class SnapshotRange {
 public:
  class Iterator {
   public:
    Iterator(const Snapshot& snapshot, uint32_t index) : snapshot_(&snapshot), index_(index) {}
    Value operator*() const;
    Iterator& operator++() {
      ++index_;
      return *this;
    }
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }

   private:
    const Snapshot* snapshot_;
    uint32_t index_;
  };

  SnapshotRange(const Snapshot& snapshot, uint32_t size) : snapshot_(snapshot), size_(size) {}
  uint32_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  Value operator[](uint32_t index) const { return *Iterator(snapshot_, index); }
  Iterator begin() const;
  Iterator end() const { return Iterator(snapshot_, size_); }

 private:
  const Snapshot& snapshot_;
  uint32_t size_;
};

/// A document as it is at one version: text, blocks, definitions, types. Immutable; the facade that everything outside
/// the compiler uses. All spans given out are absolute byte ranges of `text()` unless said otherwise.
/// A project of several files is seen from one of them. What is found in another file has a span behind the end of
/// `text()`: `place` tells where that is.
class Snapshot {
 public:
  /// Of the file.
  const SourceText& text() const;
  SnapshotRange<Block, BlockId> blocks() const;
  SnapshotRange<Definition, DefinitionId> definitions() const;
  /// The file's, then those of all others.
  SnapshotRange<Definition, DefinitionId> all_definitions() const;
  FileId file() const;
  uint32_t file_count() const;
  const SourceText& text(FileId file) const;
  TextLanguage language(FileId file) const;
  FilePlace place(Span span) const;
  bool is_in_file(Span span) const { return span.end <= text().size(); }
  Block block(BlockId id) const;
  Definition definition(DefinitionId id) const;
  const DefinitionSyntax& syntax(DefinitionId id) const;
  const ParsedBlock& parsed(BlockId id) const;
  const BlockNames& names_of(BlockId id) const;
  /// The last block of the file that starts at or before the offset.
  std::optional<BlockId> block_at(uint32_t offset) const;
  DefinitionRange definitions_of(BlockId id) const;
  const NameTable& names() const;
  /// The same table; a Document keeps it across edits as long as it can.
  std::shared_ptr<const NameTable> shared_names() const;
  Counters counters() const;
  /// Greater than that of an earlier snapshot where blocks that were not edited have been read in another way since.
  uint64_t rereadings() const;

  /// The absolute range of a location.
  Span absolute(const Location& location) const;
  Span absolute(BlockId block, Span relative) const;

  /// The canonical name of the definition that is the BRDF: the one that `% texbrdf: root = …` names, else the one that
  /// looks like it (root_choice.h); `f` where there is none.
  std::string root_name() const;
  /// All that stand in the document; the first one counts.
  std::vector<RootDirective> root_directives() const;
  /// False where nothing in the document looks like a BRDF and no comment `% texbrdf:` stands in it.
  bool is_ours() const;
  /// Some definition is made of an integral: values may be inexact.
  bool holds_integrals() const;

  /// In document order; what depends on the whole document (nearest names, redefinitions, cycles, the root) is added
  /// here. Errors and warnings about definitions that the root does not need are hints. Formed once.
  const std::vector<Diagnostic>& diagnostics() const;
  /// As if `root` (canonical) were the root; empty: root_name().
  std::vector<Diagnostic> diagnostics(std::string_view root) const;
  bool has_errors() const;

  /// The definition in force.
  std::optional<DefinitionId> find(std::string_view canonical) const;
  std::optional<DefinitionId> find(NameId name) const;
  /// The name whose spelling contains or touches the offset; the innermost one (\omega_i inside \vec{\omega_i} is not
  /// a name of its own).
  std::optional<Occurrence> occurrence_at(uint32_t offset) const;
  /// All that the document defines, by name.
  std::vector<DocumentMacro> macros() const;
  /// The macro whose name touches the offset, where it is used or defined.
  std::optional<MacroOccurrence> macro_at(uint32_t offset) const;
  /// Where a macro stands, in document order: in equations, prose, the bodies of other macros, and where it is defined.
  std::vector<Span> places_of_macro(std::string_view name) const;
  /// All occurrences of the same thing, in document order, with its declaration.
  std::vector<Occurrence> occurrences_of(const Occurrence& occurrence) const;

  /// The value of a plain definition that depends on no direction; nothing where it has none, or where it needs more
  /// than 200 other names.
  std::optional<std::vector<double>> constant_value(DefinitionId id) const;
  /// In document order, at most so many; none of which nothing is to be told.
  std::vector<RestatedDefinition> restatements(size_t most) const;
  CheckedRestatement check_restatement(const RestatedDefinition& restated) const;
  /// A comment `% texbrdf: allow CODE` says that nothing of the code is told there.
  bool allows(Code code, BlockId block) const;
  /// All names that the definitions in force of these need, themselves included; each once. A function is taken as the
  /// BRDF, which needs what its parameters are called.
  std::vector<NameId> needs_of(std::span<const NameId> names) const;
  /// The equation's source on one line, white space folded.
  std::string equation(DefinitionId id) const;

  /// What the linker needs of a definition; nullptr where it is not sound.
  const ir::LinkableDefinition* linkable(NameId name) const { return linkable(Instance{name, {}}); }
  /// Precondition: a sound definition calls the instance, or it has no parameters.
  const ir::LinkableDefinition* linkable(const Instance& instance) const;
  /// Everything that a root needs, or why it cannot be had, in one line for a person. Empty `root`: root_name().
  Result<ir::Program> program(std::string_view root = {}, const ir::LinkOptions& options = {}) const;

  /// Makes going through all blocks or definitions cheap; `blocks` and `definitions` do it when they are gone through.
  void list_all() const;

  struct State;
  explicit Snapshot(std::shared_ptr<const State> state);

 private:
  std::shared_ptr<const State> state_;
};

template <typename Value, typename Id>
Value SnapshotRange<Value, Id>::Iterator::operator*() const {
  if constexpr (std::is_same_v<Id, BlockId>) {
    return snapshot_->block(Id{index_});
  } else {
    return snapshot_->definition(Id{index_});
  }
}

template <typename Value, typename Id>
typename SnapshotRange<Value, Id>::Iterator SnapshotRange<Value, Id>::begin() const {
  snapshot_.list_all();
  return Iterator(snapshot_, 0);
}

}  // namespace texbrdf
