#pragma once

#include <vector>

#include "web/routes.h"

namespace texbrdf::pane {

/// False where the program was built without what bundles the pane of the preview.
bool is_built();
/// The pane of the preview for browsers; without it, a page that says so.
std::vector<web::Page> pages();

}  // namespace texbrdf::pane
