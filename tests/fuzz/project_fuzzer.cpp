// Any changes of a project: files that come, go and are edited leave what a new project of the same files has, seen
// from each of them. An input is the first file, then changes, each behind a byte 0xFF: one byte for what is done, one
// for the file, then the text of a file that comes, or for an edit two bytes of place, one of length, and the new text.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include "fuzz/describe.h"

namespace {

using namespace texbrdf;
using test::byte_at;

constexpr std::size_t kMaxInput = 1 << 13;
constexpr int kMaxChanges = 24;
constexpr uint32_t kMaxFiles = 6;

void edit(std::string_view change, Document& document) {
  if (change.size() < 5) return;
  const FileId file{byte_at(change, 1) % document.file_count()};
  const uint32_t begin = (byte_at(change, 2) * 256 + byte_at(change, 3)) % (document.text(file).size() + 1);
  document.replace(file, {begin, begin + byte_at(change, 4)}, change.substr(5));
}

void insert(std::string_view change, Document& document) {
  if (document.file_count() == kMaxFiles) return;
  document.insert_file({1 + byte_at(change, 1) % document.file_count()}, SourceText(change.substr(2)));
}

void remove(std::string_view change, Document& document) {
  if (document.file_count() == 1) return;
  document.remove_file({1 + byte_at(change, 1) % (document.file_count() - 1)});
}

void set_text(std::string_view change, Document& document) {
  document.set_text({byte_at(change, 1) % document.file_count()}, change.substr(2));
}

constexpr std::array kChanges = {edit, insert, remove, set_text};

/// Above what is done: nobody looks at the project before the next change.
constexpr uint32_t kUnseen = 0x40;
/// Above what is done: there is time before the next change.
constexpr uint32_t kPrepared = 0x20;

Document fresh_copy(const Document& document) {
  Document fresh(document.text().bytes());
  for (uint32_t file = 1; file < document.file_count(); ++file) {
    fresh.insert_file({file}, SourceText(document.text({file}).bytes()));
  }
  return fresh;
}

void expect_as_fresh(Document& document) {
  Document fresh = fresh_copy(document);
  for (uint32_t file = 0; file < document.file_count(); ++file) {
    test::expect_equal(test::describe(document.snapshot({file})), test::describe(fresh.snapshot({file})));
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, std::size_t size) {
  if (size > kMaxInput) return 0;
  std::string_view input(reinterpret_cast<const char*>(data), size);
  Document document{std::string(test::take_piece(input))};
  document.snapshot();
  for (int i = 0; i < kMaxChanges && !input.empty(); ++i) {
    const std::string_view change = test::take_piece(input);
    if (change.size() < 2) continue;
    const uint32_t what = byte_at(change, 0);
    kChanges[what % kChanges.size()](change, document);
    if ((what & kUnseen) != 0 && !input.empty()) continue;
    expect_as_fresh(document);
    if ((what & kPrepared) != 0) document.prepare_for_edits();
  }
  return 0;
}
