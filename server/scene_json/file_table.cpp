#include "scene_json/file_table.h"

#include <fmt/format.h>

#include <utility>
#include <variant>

#include "scene_json/load_scene.h"

namespace texbrdf::scene_json {

std::string FileTable::resolve(const JsonFile& file, std::string_view path) {
  if (path.starts_with('/')) return files::real_path(path);
  return files::real_path(fmt::format("{}/{}", files::folder_of(file.path), path));
}

std::string FileTable::shown(const std::string& path, const JsonFile& from) {
  const std::string folder = files::folder_of(from.path);
  return files::is_below(path, folder) ? path.substr(folder.size() + 1) : path;
}

std::string_view FileTable::why_not(const std::string& path) const {
  const bool is_outside = !path.empty() && !source_.may_read(path);
  return is_outside ? "is not in a folder of the workspace" : "cannot be read";
}

void FileTable::report(const Origin* from, const std::string& path, std::string message) {
  if (from != nullptr) {
    problems_.add(*from->file, from->id, std::move(message));
  } else {
    problems_.add(path, SourceText(), {}, {}, std::move(message));
  }
}

const JsonFile* FileTable::open(const std::string& path, const Origin* from) {
  if (const auto found = files_.find(path); found != files_.end()) return found->second.get();
  if (files_.size() >= kMaxFiles) {
    report(from, path, fmt::format("the scene has more than {} files", kMaxFiles));
    return nullptr;
  }
  const std::optional<SourceText> read = text(path);
  if (!read) {
    report(from, path, fmt::format("the file {} {}", from == nullptr ? path : shown(path, *from->file), why_not(path)));
    return nullptr;
  }
  std::unique_ptr<JsonFile>& entry = files_[path];
  auto parsed =
      read->size() > kMaxJsonBytes
          ? std::variant<JsonTree, JsonFault>(JsonFault{{}, fmt::format("longer than {} bytes", kMaxJsonBytes)})
          : parse_json(read->bytes());
  if (auto* fault = std::get_if<JsonFault>(&parsed)) {
    problems_.add(path, *read, {}, fault->span, std::move(fault->message));
    return nullptr;
  }
  entry = std::make_unique<JsonFile>(JsonFile{path, *read, std::get<JsonTree>(std::move(parsed))});
  return entry.get();
}

bool FileTable::exists(const std::string& path) const {
  asked_[path] = true;
  return source_.exists(path);
}

std::optional<SourceText> FileTable::text(const std::string& path) {
  asked_[path] = true;
  if (path.empty() || !source_.may_read(path)) return std::nullopt;
  return source_.text(path);
}

std::vector<std::string> FileTable::paths() const {
  std::vector<std::string> paths;
  for (const auto& [path, asked] : asked_) paths.push_back(path);
  return paths;
}

}  // namespace texbrdf::scene_json
