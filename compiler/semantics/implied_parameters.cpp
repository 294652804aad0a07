#include "semantics/implied_parameters.h"

#include <algorithm>
#include <span>

#include "semantics/known_names.h"

namespace texbrdf {
namespace {

/// How many definitions before and behind are looked at: a long display is no where-clause.
constexpr size_t kReach = 8;

class Neighbours {
 public:
  explicit Neighbours(const DefinitionView& view) : view_(view) {
    const std::span all(view.block.definitions);
    const auto own = std::ranges::lower_bound(all, view.syntax.node, {}, &DefinitionSyntax::node);
    const auto index = static_cast<size_t>(own - all.begin());
    const size_t first = index - std::min(index, kReach);
    near_ = all.subspan(first, std::min(all.size(), index + kReach + 1) - first);
  }

  std::vector<NameId> run() {
    std::vector<NameId> parameters;
    if (std::ranges::none_of(near_, is_function)) return parameters;
    users_ = {view_.name(view_.syntax.name)};
    for (size_t i = 0; i < users_.size(); ++i) add_plain_users(users_[i]);
    for (const DefinitionSyntax& definition : near_) {
      if (!is_function(definition) || !mentions_user(definition)) continue;
      const std::vector<NameId> own = parameter_names(view_.block, definition, view_.names);
      if (!is_brdf_of_convention(definition, own)) parameters.insert(parameters.end(), own.begin(), own.end());
    }
    return parameters;
  }

 private:
  static bool is_function(const DefinitionSyntax& definition) { return definition.left != definition.name; }

  /// `f_r(\omega_i, \omega_o)`: its parameters are what the convention has anyway.
  bool is_brdf_of_convention(const DefinitionSyntax& function, std::span<const NameId> parameters) const {
    const auto is = [&](NameId name, Convention convention) {
      return name.valid() && view_.table.traits(name).convention == convention;
    };
    return view_.table.traits(view_.name(function.name)).may_be_brdf && parameters.size() == 2 &&
           is(parameters[0], Convention::OmegaI) && is(parameters[1], Convention::OmegaO);
  }

  void add_plain_users(NameId used) {
    for (const DefinitionSyntax& definition : near_) {
      const NameId name = view_.name(definition.name);
      const bool is_known = std::ranges::find(users_, name) != users_.end();
      if (!is_function(definition) && !is_known && mentions(definition, used)) users_.push_back(name);
    }
  }

  bool mentions_user(const DefinitionSyntax& definition) const {
    return std::ranges::any_of(users_, [&](NameId user) { return mentions(definition, user); });
  }

  bool mentions(const DefinitionSyntax& definition, NameId name) const {
    const auto body = std::span(view_.names.by_node)
                          .subspan(definition.left.value + 1, definition.body.value - definition.left.value);
    return std::ranges::find(body, name) != body.end();
  }

  const DefinitionView& view_;
  std::span<const DefinitionSyntax> near_;
  std::vector<NameId> users_;  // what the definition is a part of, itself included
};

}  // namespace

std::vector<NameId> parameters_of_users(const DefinitionView& view) {
  const bool is_plain = view.syntax.left == view.syntax.name;
  const bool has_neighbours = view.block.definitions.size() > 1;
  return is_plain && has_neighbours ? Neighbours(view).run() : std::vector<NameId>();
}

}  // namespace texbrdf
