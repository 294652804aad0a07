#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "features/describe.h"
#include "lsp/json_writer.h"

namespace texbrdf::lsp {

/// The first of the client's formats that is known here; `if_silent` where it names none.
features::Markup preferred_markup(const std::vector<std::string>& formats, features::Markup if_silent);

/// MarkupContent
void write_markup(JsonWriter& out, std::string_view key, std::string_view text, features::Markup markup);

}  // namespace texbrdf::lsp
