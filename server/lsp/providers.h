#pragma once

#include <span>

#include "lsp/settings.h"

namespace texbrdf::lsp {

/// How a feature is announced, from providers.def.
struct Provider {
  Feature feature;
  const char* capability;  ///< member of the server's capabilities
  const char* method;      ///< to register it by
  const char* client_capability;
  const char* refresh_capability;  ///< empty where a client does not keep results
  const char* refresh_method;
};

std::span<const Provider> providers();

}  // namespace texbrdf::lsp
