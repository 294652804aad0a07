#pragma once

#include "cli/exit_code.h"
#include "render/worker_client.h"

namespace texbrdf::cli {

/// Says on standard error why the GPU gave nothing, and what to exit with.
ExitCode report_render_fault(const render::RenderFault& fault);

}  // namespace texbrdf::cli
