#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace texbrdf::web {

/// 132 random bits in letters that need no escape; nothing where the system has none to give.
std::optional<std::string> make_token();

/// In a time that does not tell how much of them is equal.
bool is_same_secret(std::string_view given, std::string_view secret);

/// A page of another site can have its own name lead to this machine (DNS rebinding), but its browser then says that
/// name in `Host`. Only these are ours: 127.0.0.1:PORT and localhost:PORT.
bool is_own_host(std::string_view host, uint16_t port);
/// The same of `Origin`: http:// before it.
bool is_own_origin(std::string_view origin, uint16_t port);

/// "main.js" of "/TOKEN/main.js"; nothing where the token is another.
std::optional<std::string_view> path_behind_token(std::string_view target, std::string_view token);

}  // namespace texbrdf::web
