#include "files/follow_includes.h"

#include <algorithm>
#include <utility>

namespace texbrdf::files {
namespace {

/// What is nested deeper, or comes on top of so many files, is not read.
constexpr std::size_t kMaxDepth = 64;
constexpr uint32_t kMaxFiles = 2000;

constexpr std::string_view kExtension = ".tex";

std::string joined(std::string_view folder, std::string_view path) {
  if (path.starts_with('/') || folder.empty()) return std::string(path);
  std::string whole(folder);
  if (!whole.ends_with('/')) whole += '/';
  return whole += path;
}

/// Where TeX would look, and where the author may have meant.
std::vector<std::string> folders_for(const IncludeTarget& target, std::string_view root, std::string_view file) {
  const std::string of_root = folder_of(root);
  const std::string of_file = folder_of(file);
  switch (target.kind) {
    case IncludeCommand::Kind::Input:
      return {of_root, of_file};
    case IncludeCommand::Kind::Subfile:
      return {of_file, of_root};
    case IncludeCommand::Kind::Import:
      return {joined(of_root, target.folder), joined(of_file, target.folder)};
    case IncludeCommand::Kind::SubImport:
      return {joined(of_file, target.folder)};
  }
  return {};
}

/// Walks the files of a project in the order of their inclusion.
class Walk {
 public:
  Walk(Document& document, std::vector<std::string>& paths, FileSource& source)
      : document_(document), paths_(paths), source_(source) {}

  bool run() {
    visit(FileId{0});
    for (uint32_t last = document_.file_count(); last > next_; --last) {
      document_.remove_file({last - 1});
      paths_.pop_back();
    }
    const bool is_complete = problems_.empty();
    document_.set_include_problems(std::move(problems_));
    return is_complete;
  }

 private:
  /// At most kMaxDepth calls deep.
  void visit(FileId file) {
    const std::string path = paths_[file.value];
    inside_.push_back(path);
    for (const IncludeTarget& target : document_.includes(file)) follow(file, path, target);
    inside_.pop_back();
  }

  void follow(FileId file, const std::string& path, const IncludeTarget& target) {
    const ResolvedInclude resolved = resolve_include(target, paths_.front(), path, source_);
    if (const Code* problem = std::get_if<Code>(&resolved)) {
      report(file, target, *problem);
      return;
    }
    const std::string& included = std::get<std::string>(resolved);
    if (std::ranges::find(inside_, included) != inside_.end()) {
      report(file, target, Code::CircularInclusion);
    } else if (!is_placed(included)) {
      if (inside_.size() < kMaxDepth && place(included)) {
        visit({next_++});
      } else {
        report(file, target, Code::FileNotFound);
      }
    }
  }

  bool is_placed(const std::string& path) const {
    const auto end = paths_.begin() + next_;
    return std::find(paths_.begin(), end, path) != end;
  }

  /// Makes it the next file.
  bool place(const std::string& path) {
    const auto found = std::find(paths_.begin() + next_, paths_.end(), path);
    const auto at = static_cast<uint32_t>(found - paths_.begin());
    if (at == next_ && found != paths_.end()) return true;
    std::optional<SourceText> text;
    if (found != paths_.end()) {
      text = document_.text({at});
      document_.remove_file({at});
      paths_.erase(found);
    } else if (document_.file_count() < kMaxFiles) {
      text = source_.text(path);
    }
    if (!text) return false;
    document_.insert_file({next_}, *text, source_.language(path));
    paths_.insert(paths_.begin() + next_, path);
    return true;
  }

  void report(FileId file, const IncludeTarget& target, Code code) {
    problems_.push_back({file, target, code, joined(target.folder, target.path)});
  }

  Document& document_;
  std::vector<std::string>& paths_;
  FileSource& source_;
  uint32_t next_ = 1;                // files before it are in their places
  std::vector<std::string> inside_;  // the files that include the one that is visited, and itself
  std::vector<IncludeProblem> problems_;
};

}  // namespace

ResolvedInclude resolve_include(const IncludeTarget& target, std::string_view root, std::string_view file,
                                const FileSource& source) {
  bool is_outside = false;
  for (const std::string& folder : folders_for(target, root, file)) {
    const std::string named = joined(folder, target.path);
    for (const std::string& path : {named + std::string(kExtension), named}) {
      const bool twice = path.size() > named.size() && named.ends_with(kExtension);
      if (twice) continue;
      const std::string real = real_path(path);
      if (!source.may_read(real)) {
        is_outside = true;
      } else if (source.exists(real)) {
        return real;
      }
    }
  }
  return is_outside ? Code::OutsideWorkspace : Code::FileNotFound;
}

bool follow_includes(Document& document, std::vector<std::string>& paths, FileSource& source) {
  return Walk(document, paths, source).run();
}

}  // namespace texbrdf::files
