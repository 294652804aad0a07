#include "files/file_source.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace texbrdf::files {

namespace fs = std::filesystem;

std::string real_path(std::string_view path) {
  std::error_code error;
  const fs::path real = fs::weakly_canonical(fs::path(path), error);
  return error ? std::string() : real.string();
}

std::string folder_of(std::string_view path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string_view::npos) return {};
  return std::string(path.substr(0, slash == 0 ? 1 : slash));
}

bool is_below(std::string_view path, std::string_view folder) {
  if (folder.empty() || !path.starts_with(folder)) return false;
  return folder.ends_with('/') || path.size() == folder.size() || path[folder.size()] == '/';
}

FileStamp stamp_of(const std::string& path) {
  std::error_code error;
  FileStamp stamp;
  stamp.exists = fs::is_regular_file(path, error);
  if (error || !stamp.exists) return {};
  stamp.size = fs::file_size(path, error);
  if (error) return {};
  stamp.modified = fs::last_write_time(path, error).time_since_epoch().count();
  return error ? FileStamp{} : stamp;
}

std::optional<std::string> read_file(const std::string& path) {
  const FileStamp stamp = stamp_of(path);
  if (!stamp.exists || stamp.size > SourceText::kMaxBytes) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string bytes(stamp.size, '\0');
  file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (file.bad() || (!bytes.empty() && file.gcount() == 0)) return std::nullopt;
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  return bytes;
}

std::optional<SourceText> DiskFiles::text(const std::string& path) {
  const std::optional<std::string> bytes = read_file(path);
  if (!bytes) return std::nullopt;
  return SourceText(*bytes);
}

}  // namespace texbrdf::files
