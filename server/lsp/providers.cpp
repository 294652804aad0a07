#include "lsp/providers.h"

namespace texbrdf::lsp {
namespace {

constexpr auto kProviders = std::to_array<Provider>({
#define PROVIDER(feature, capability, method, client_capability, refresh_capability, refresh_method) \
  {Feature::feature, capability, method, client_capability, refresh_capability, refresh_method},
#include "lsp/providers.def"
#undef PROVIDER
});

}  // namespace

std::span<const Provider> providers() {
  return kProviders;
}

}  // namespace texbrdf::lsp
