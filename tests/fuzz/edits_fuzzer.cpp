// Any edits of any document: what is kept from before an edit gives what a new document with the same text gives. An
// input is the document, then edits, each behind a byte 0xFF: two bytes of place, one of length, and the new text.
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/describe.h"

namespace {

using namespace texbrdf;
using test::byte_at;

constexpr std::size_t kMaxInput = 1 << 13;
constexpr int kMaxEdits = 24;

void apply(std::string_view edit, Document& document) {
  if (edit.size() < 3) return;
  const uint32_t begin = (byte_at(edit, 0) * 256 + byte_at(edit, 1)) % (document.text().size() + 1);
  document.replace({begin, begin + byte_at(edit, 2)}, edit.substr(3));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  std::string_view input(reinterpret_cast<const char*>(data), size);
  Document document{std::string(test::take_piece(input))};
  document.snapshot();
  for (int i = 0; i < kMaxEdits && !input.empty(); ++i) {
    apply(test::take_piece(input), document);
    Document fresh(document.text().bytes());
    test::expect_equal(test::describe(document.snapshot()), test::describe(fresh.snapshot()));
  }
  return 0;
}
