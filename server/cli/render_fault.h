#pragma once

#include <string_view>

#include "cli/exit_code.h"
#include "render/worker_client.h"

namespace texbrdf::cli {

/// Says on standard error why the GPU gave nothing and, where that can help, what to do; returns what to exit with.
ExitCode report_render_fault(const render::RenderFault& fault,
                             std::string_view advice = "--device cpu needs no renderer");

}  // namespace texbrdf::cli
