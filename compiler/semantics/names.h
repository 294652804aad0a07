#pragma once

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "semantics/binders.h"
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
  std::string label;          ///< "1" of `f^{(1)}`
  bool is_in_angles = false;  ///< all of it: `\langle E\rangle`, a mean
  bool is_hat_apart = false;  ///< `\hat{\mathbf h}` where that is another vector than `\mathbf h`

  bool is_vector() const { return !decorations.empty() && decorations.front() == "vec"; }
};

/// The structure of a Name node.
Name read_name(const ParsedBlock& block, NodeId id);
/// Equal for equal names, and itself a valid spelling of the name: `\phi_{diff}`, `x_1`, `\vec{n}`. The spellings of
/// one convention are one name: `\vec{\omega_i}` gives `\omega_i`.
std::string canonical_form(const Name& name);

/// A name as a person types it. Nothing where it is no name.
std::optional<Name> name_spelled(std::string_view spelling);
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

/// A Name that a binder binds: where it is declared, and where it is used. The variable of a derivative is declared
/// nowhere: it is what the name means around the derivative.
struct BoundUse {
  NodeId node;
  uint32_t binder = 0;  ///< position in BlockNames::binders
};

/// A Name that stands for others where nothing has it itself: `a_k` below a sum over k for `a_1`, `a_2` …, and `f''`
/// for `f`, of which it is the second derivative where nothing has `f'` either.
struct StandIn {
  NodeId node;
  std::vector<uint32_t> binders;  ///< whose indices it bears, outermost first; none for a derivative
  std::vector<NameId> names;      ///< by index, that of the last binder fastest
};

/// Another name that a node is where the document defines it: `\langle E\rangle` of Angles around a Name, which is the
/// positive part of E else, and `\hat{\mathbf h}`, which is `\mathbf h` else.
struct PossibleName {
  NodeId node;
  NameId name;
};

/// The names of one block: by NodeId for Name nodes, invalid for all others.
struct BlockNames {
  std::pmr::vector<NameId> by_node;
  std::vector<Binder> binders = {};
  std::vector<BoundUse> bound = {};         ///< by node, in order
  std::vector<StandIn> stand_ins = {};      ///< by node, in order
  std::vector<PossibleName> possible = {};  ///< by node, in order

  const BoundUse* bound_use(NodeId node) const;
  const StandIn* stand_in(NodeId node) const;

  /// Of a parameter on a left side: invalid where it is an expression that gives no name a value.
  NameId of_parameter(const ParsedBlock& block, NodeId parameter) const {
    const NodeId name = block.parameter_name(parameter);
    return name.valid() ? by_node[name.value] : NameId{};
  }
};

/// Elements of a vector literal are no names: they must be numbers.
BlockNames read_names(const ParsedBlock& block, NameTable& table,
                      std::pmr::memory_resource* memory = std::pmr::get_default_resource());

}  // namespace texbrdf
