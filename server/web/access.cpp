#include "web/access.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>

namespace texbrdf::web {
namespace {

constexpr std::size_t kTokenLetters = 22;
constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr std::string_view kOwnScheme = "http://";
constexpr uint16_t kUsualPort = 80;

}  // namespace

std::optional<std::string> make_token() {
  std::array<uint8_t, kTokenLetters> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) return std::nullopt;
  std::string token;
  for (const uint8_t byte : bytes) token += kLetters[byte % kLetters.size()];
  return token;
}

bool is_same_secret(std::string_view given, std::string_view secret) {
  if (given.size() != secret.size()) return false;
  volatile uint8_t difference = 0;  // so that the loop cannot end early
  for (std::size_t i = 0; i < secret.size(); ++i) {
    difference = static_cast<uint8_t>(difference | static_cast<uint8_t>(given[i] ^ secret[i]));
  }
  return difference == 0;
}

bool is_own_host(std::string_view host, uint16_t port) {
  // Browsers leave out the port that is usual.
  if (port == kUsualPort && (host == "127.0.0.1" || host == "localhost")) return true;
  return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
}

bool is_own_origin(std::string_view origin, uint16_t port) {
  return origin.starts_with(kOwnScheme) && is_own_host(origin.substr(kOwnScheme.size()), port);
}

std::optional<std::string_view> path_behind_token(std::string_view target, std::string_view token) {
  if (token.empty() || !target.starts_with('/')) return std::nullopt;
  target.remove_prefix(1);
  const std::size_t end = target.find('/');
  if (end == std::string_view::npos || !is_same_secret(target.substr(0, end), token)) return std::nullopt;
  return target.substr(end + 1);
}

}  // namespace texbrdf::web
