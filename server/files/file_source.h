#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "source/source_text.h"
#include "source/text_language.h"

namespace texbrdf::files {

/// Where the files that a project includes come from. Paths are absolute, without `.`, `..` and symbolic links.
class FileSource {
 public:
  FileSource() = default;
  FileSource(const FileSource&) = delete;
  FileSource& operator=(const FileSource&) = delete;
  virtual ~FileSource() = default;

  /// A file there may be looked at.
  virtual bool may_read(std::string_view path) const = 0;
  virtual bool exists(const std::string& path) const = 0;
  /// Nothing where it cannot be read.
  virtual std::optional<SourceText> text(const std::string& path) = 0;
  virtual TextLanguage language(const std::string& path) const { return language_of_path(path); }
};

/// Absolute, without `.`, `..` and, as far as it exists, without symbolic links; empty where that cannot be had.
std::string real_path(std::string_view path);
/// Without the last name.
std::string folder_of(std::string_view path);
/// `path` is the folder or below it; both are real.
bool is_below(std::string_view path, std::string_view folder);

/// A state of a file on the disk; compares unequal when the file was changed.
struct FileStamp {
  int64_t modified = 0;
  uint64_t size = 0;
  bool exists = false;
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};
FileStamp stamp_of(const std::string& path);
/// The bytes of a regular file; nothing where it cannot be read or is longer than a document may be.
std::optional<std::string> read_file(const std::string& path);

/// All files of the disk.
class DiskFiles final : public FileSource {
 public:
  bool may_read(std::string_view) const override { return true; }
  bool exists(const std::string& path) const override { return stamp_of(path).exists; }
  std::optional<SourceText> text(const std::string& path) override;
};

}  // namespace texbrdf::files
