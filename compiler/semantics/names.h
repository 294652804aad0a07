#pragma once

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "semantics/name_traits.h"
#include "syntax/parsed_block.h"

namespace texbrdf {

/// Index of a canonical name in a NameTable.
struct NameId {
  uint32_t value = UINT32_MAX;
  constexpr bool valid() const { return value != UINT32_MAX; }
  friend constexpr auto operator<=>(const NameId&, const NameId&) = default;
};

/// A name as a reader sees it: \vec{\omega_i} is (vec, \omega, [i]), and so are \vec{\omega}_i and \mathbf\omega_i. The
/// one place that decides which spellings are the same name is `canonical_form`.
struct Name {
  std::string base;         ///< "rho" of \rho, "val", "cook_torrance" of \text{cook\_torrance}
  bool is_command = false;  ///< the base is written with a backslash
  bool is_text = false;     ///< the base is written as \text{…}, \mathrm{…} …
  /// The decorations around it, outermost first: "vec" for all that make a vector's name, else as written ("bar").
  std::vector<std::string> decorations;
  std::vector<std::string> subscripts;  ///< canonical forms without braces, in order
  uint32_t primes = 0;

  bool is_vector() const { return !decorations.empty() && decorations.front() == "vec"; }
};

/// The structure of a Name node.
Name read_name(const ParsedBlock& block, NodeId id);
/// Equal for equal names, and itself a valid spelling of the name: `\phi_{diff}`, `x_1`, `\vec{n}`. The spellings of
/// one convention are one name: `\vec{\omega_i}` gives `\omega_i`.
std::string canonical_form(const Name& name);

/// The canonical form of a name as a person types it: `x_{1}` gives `x_1`, `\vec{n}` gives `\vec{n}`. Nothing where it
/// is no name.
std::optional<std::string> canonical_name(std::string_view spelling);

/// A name as messages show it: the end of a very long one is left out.
std::string shown_name(std::string_view canonical);

/// A decorated name as the source spells it, so that nobody who wrote `\mathbf{n}` is told of `\vec{n}`; else the
/// canonical form.
std::string shown_spelling(std::string_view source, std::string_view canonical);

/// Interns canonical names; ids stay valid as long as the table. One language thread writes; others may call `text`,
/// `traits` and `find` at the same time for what was interned before they got the table.
class NameTable {
 public:
  NameTable();
  NameTable(const NameTable&) = delete;
  NameTable& operator=(const NameTable&) = delete;
  ~NameTable();

  NameId intern(std::string_view canonical);
  /// By the canonical form, or another spelling that was met. Invalid where the name was never interned.
  NameId find(std::string_view spelling) const;
  std::string_view text(NameId id) const;
  const NameTraits& traits(NameId id) const;
  uint32_t size() const;

  /// Notes that source text spells the name, so that it need not be read again. Precondition: `find` does not know it.
  void add_spelling(std::string_view spelling, NameId id);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The names of one block: by NodeId for Name nodes, invalid for all others.
struct BlockNames {
  std::pmr::vector<NameId> by_node;
};

/// Elements of a vector literal are no names: they must be numbers.
BlockNames read_names(const ParsedBlock& block, NameTable& table,
                      std::pmr::memory_resource* memory = std::pmr::get_default_resource());

}  // namespace texbrdf
