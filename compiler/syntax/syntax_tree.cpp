#include "syntax/syntax_tree.h"

namespace texbrdf {

std::string_view node_kind_name(NodeKind kind) {
  switch (kind) {
#define NODE_KIND(name, description) \
  case NodeKind::name:               \
    return #name;
#include "syntax/node_kind.def"
#undef NODE_KIND
  }
  return {};
}

void SyntaxTree::reserve(uint32_t nodes) {
  nodes_.reserve(nodes);
  children_.reserve(nodes);
}

}  // namespace texbrdf
