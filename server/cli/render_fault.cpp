#include "cli/render_fault.h"

#include <fmt/core.h>

#include "cli/messages.h"

namespace texbrdf::cli {

ExitCode report_render_fault(const render::RenderFault& fault, std::string_view advice) {
  print_message(fault.message);
  switch (fault.kind) {
    case render::RenderFaultKind::Request:
      return ExitCode::BadUsage;
    case render::RenderFaultKind::NoRenderer:
    case render::RenderFaultKind::Shader:
    case render::RenderFaultKind::Crash:
    case render::RenderFaultKind::Deadline:
    case render::RenderFaultKind::Protocol:
      if (!advice.empty()) print_message(advice);
      return ExitCode::NoRenderer;
  }
  return ExitCode::NoRenderer;
}

}  // namespace texbrdf::cli
