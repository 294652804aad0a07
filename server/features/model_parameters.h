#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/snapshot.h"
#include "features/text_edit.h"

namespace texbrdf::features {

/// A number or colour of the document that a person may turn.
struct ModelParameter {
  std::string name;               ///< canonical
  std::string spelling;           ///< LaTeX, as its definition writes it
  Type type = Type::Real;         ///< Real or Colour
  std::array<double, 3> value{};  ///< linear RGB for a colour; value[0] for a real
  double low = 0;                 ///< of every component
  double high = 1;
  Span literal;  ///< absolute: the number or the vector literal
};

/// Those that a root needs, in document order of first need; none where it cannot be had. Empty `root`: the document's.
std::vector<ModelParameter> model_parameters(const Snapshot& snapshot, std::string_view root = {});

/// Canonical names of the definitions that may be the BRDF, in document order.
std::vector<std::string> brdf_names(const Snapshot& snapshot);

/// The changes that write a value into the document, in its own notation; nothing where there is no such parameter or
/// the value is none of it. A number of up to six digits is written as it is, without zeros at its end; a longer one is
/// rounded to a thousandth of the parameter's range.
std::optional<std::vector<TextEdit>> parameter_edit(const Snapshot& snapshot, std::string_view name,
                                                    std::span<const double> value);

}  // namespace texbrdf::features
