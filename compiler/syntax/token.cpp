#include "syntax/token.h"

namespace texbrdf {

std::string_view token_kind_name(TokenKind kind) {
  switch (kind) {
#define TOKEN_KIND(name, description) \
  case TokenKind::name:               \
    return #name;
#include "syntax/token_kind.def"
#undef TOKEN_KIND
  }
  return {};
}

}  // namespace texbrdf
