#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/document.h"
#include "features/text_edit.h"
#include "files/file_source.h"

namespace texbrdf::lsp {

/// A root file and all that it includes.
struct Project {
  Document document;
  std::vector<std::string> paths;                    ///< by FileId
  std::vector<files::FileStamp> stamps;              ///< of the files when they were read
  std::vector<std::vector<IncludeTarget>> includes;  ///< what was followed, by FileId
  bool is_complete = true;                           ///< everything could be followed
  uint64_t state = 0;  ///< another for each project, and whenever files came, went or were read anew

  std::optional<FileId> find(std::string_view path) const;
};

/// The text of a document that the client has open, and the project that it is seen in.
struct Buffer {
  std::string path;  ///< real; the URI where it is no file
  SourceText text;
  Project* home = nullptr;
  FileId file;                                 ///< in its home
  bool is_new = true;                          ///< projects that have the file have its text on the disk
  std::vector<features::TextEdit> edits = {};  ///< that no project has made yet
  TextLanguage language = TextLanguage::Latex;
};

/// Keeps the projects of the open documents. What the client has open is never read from the disk.
class Projects final : public files::FileSource {
 public:
  /// Only files below them are read.
  void set_folders(std::span<const std::string> paths);

  Buffer& open(std::string path, SourceText text, TextLanguage language = TextLanguage::Latex);
  void close(Buffer& buffer);
  void replace(Buffer& buffer, Span span, std::string_view replacement);
  /// Drops all that was found out about the texts. They themselves cannot be lost to a fault in finding it out.
  void start_anew();
  /// Files may have come, gone or changed.
  void disk_changed();

  const Snapshot& snapshot(Buffer& buffer);
  /// Of a file of the project.
  const Buffer* find_buffer(std::string_view path) const;
  /// Brings the projects up to the texts, and gives each buffer its home.
  void settle();
  /// The last state of a project that was given out.
  uint64_t last_state() const { return last_state_; }

  bool may_read(std::string_view path) const override;
  bool exists(const std::string& path) const override;
  std::optional<SourceText> text(const std::string& path) override;
  TextLanguage language(const std::string& path) const override;

 private:
  void take_texts(Buffer& buffer);
  void take_edit(const Buffer& buffer, const features::TextEdit& edit);
  void look_at_disk();
  void reread_changed(Project& project);
  void follow(Project& project);
  void find_homes();
  Project* home_by_root(const Buffer& buffer);
  std::string find_root(const std::string& path);
  std::string find_includer(const std::string& path);
  Project* project_of_root(const std::string& root);
  bool is_first_root(std::size_t buffer) const;
  bool includes(const Buffer& root, const Buffer& other) const;
  void drop_unused();

  struct KnownFile {
    files::FileStamp stamp;
    std::vector<IncludeTarget> includes;
    std::optional<std::string> root;  ///< that it names
  };
  const KnownFile& look_into(const std::string& path);

  std::vector<std::string> folders_;
  std::vector<std::unique_ptr<Buffer>> buffers_;  // in the order of opening
  std::vector<std::unique_ptr<Project>> projects_;
  std::map<std::string, KnownFile> known_;    // files that were looked into for their includes
  std::map<std::string, std::string> roots_;  // by path of a buffer; until the disk changes
  bool is_settled_ = true;
  uint64_t last_state_ = 0;
  std::chrono::steady_clock::time_point looked_{};
};

/// An open document as the features see it: one file of a project.
class ProjectDocument {
 public:
  ProjectDocument(Projects& projects, Buffer& buffer) : projects_(&projects), buffer_(&buffer) {}

  /// Ends the life of those given out before where a file has changed.
  const Snapshot& snapshot() { return projects_->snapshot(*buffer_); }
  /// The one that was given out last.
  const Snapshot& present_snapshot() const { return buffer_->home->document.snapshot(buffer_->file); }
  const SourceText& text() const { return buffer_->text; }
  void replace(Span span, std::string_view replacement) { projects_->replace(*buffer_, span, replacement); }
  void set_text(std::string_view text);
  void prepare_for_edits();
  /// After `snapshot`.
  const Project& project() const { return *buffer_->home; }
  Buffer& buffer() const { return *buffer_; }

 private:
  Projects* projects_;
  Buffer* buffer_;
};

}  // namespace texbrdf::lsp
