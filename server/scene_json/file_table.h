#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "files/file_source.h"
#include "scene_json/object_reader.h"

namespace texbrdf::scene_json {

/// A value in one of the files.
struct Origin {
  const JsonFile* file = nullptr;
  JsonId id;
  friend auto operator<=>(const Origin&, const Origin&) = default;
};

/// The files of a scene, each read once.
class FileTable final : public files::FileSource {
 public:
  FileTable(files::FileSource& source, Problems& problems) : source_(source), problems_(problems) {}

  /// nullptr where it cannot be read, which has been reported: at `from`, which names it, or in the file itself.
  const JsonFile* open(const std::string& path, const Origin* from);
  /// The real path of what a value of `file` names.
  static std::string resolve(const JsonFile& file, std::string_view path);
  /// The path as it is told about in messages of `from`.
  static std::string shown(const std::string& path, const JsonFile& from);
  /// "cannot be read", of what has no text.
  std::string_view why_not(const std::string& path) const;
  /// All that was asked for.
  std::vector<std::string> paths() const;

  bool may_read(std::string_view path) const override { return source_.may_read(path); }
  bool exists(const std::string& path) const override;
  std::optional<SourceText> text(const std::string& path) override;
  TextLanguage language(const std::string& path) const override { return source_.language(path); }

 private:
  void report(const Origin* from, const std::string& path, std::string message);

  files::FileSource& source_;
  Problems& problems_;
  std::map<std::string, std::unique_ptr<JsonFile>> files_;  // nullptr where it cannot be read
  mutable std::map<std::string, bool> asked_;
};

}  // namespace texbrdf::scene_json
