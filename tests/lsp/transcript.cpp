#include "transcript.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>
#include <vector>

#include "lsp/framing.h"
#include "lsp/server.h"
#include "support/memory_channel.h"

namespace texbrdf::test {
namespace {

using json = nlohmann::ordered_json;

constexpr std::string_view kFolder = "file:///work";
constexpr std::size_t kLineWidth = 110;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

/// The first word; it and the space behind it are taken away.
std::string take_word(std::string_view& text) {
  const std::size_t end = std::min(text.find(' '), text.size());
  std::string word(text.substr(0, end));
  text.remove_prefix(std::min(end + 1, text.size()));
  return word;
}

// --- what the client says ---

json read_position(std::string_view text) {
  const std::size_t colon = text.find(':');
  return {{"line", std::stol(std::string(text.substr(0, colon))) - 1},
          {"character", std::stol(std::string(text.substr(colon + 1))) - 1}};
}

json read_range(std::string_view text) {
  const std::size_t dash = text.find('-');
  return {{"start", read_position(text.substr(0, dash))}, {"end", read_position(text.substr(dash + 1))}};
}

json document(const std::string& name) {
  return {{"uri", std::string(kFolder) + "/" + name}};
}

json expanded(const std::string& text) {
  if (text.empty()) return nullptr;
  json params = json::parse(text);
  if (!params.is_object()) return params;
  if (params.contains("doc")) params["textDocument"] = document(params["doc"]);
  if (params.contains("at")) params["position"] = read_position(params["at"].get<std::string>());
  params.erase("doc");
  params.erase("at");
  return params;
}

bool is_notification(std::string_view method) {
  constexpr std::array kOfPreviews = {"texbrdf/updatePreview", "texbrdf/closePreview", "texbrdf/frameShown",
                                      "texbrdf/updateScene",   "texbrdf/sceneInput",   "texbrdf/setParameter"};
  return method == "initialized" || method == "exit" || method.starts_with("$/") ||
         std::ranges::find(kOfPreviews, method) != kOfPreviews.end() || method.starts_with("textDocument/did") ||
         method.starts_with("workspace/did") || method.starts_with("notify/");
}

/// Turns the lines of a transcript into bytes.
class Client {
 public:
  explicit Client(std::string folder) : folder_(std::move(folder)) {}

  /// Empty where the line says nothing to the server.
  std::string bytes_of(std::string_view line, const std::string& document_text) {
    const std::string verb = take_word(line);
    if (verb == "client") return message("initialize", expanded(std::string(line)));
    if (verb == "->" || verb == "+>") {
      const std::string method = take_word(line);
      return message(method, expanded(std::string(line)));
    }
    if (verb == "+") return bytes_of(line, document_text);
    if (verb == "open") return open(std::string(line), document_text);
    if (verb == "change") return change(line);
    if (verb == "reply") return reply(line);
    if (verb == "raw") return json::parse(line).get<std::string>();
    if (verb == "file" || verb == "remove" || verb == "link") return {};
    if (verb == "frame") return lsp::frame(json::parse(line).get<std::string>());
    throw std::runtime_error("a transcript does not know: " + verb);
  }

 private:
  std::string message(const std::string& method, json params) {
    json body = {{"jsonrpc", "2.0"}};
    if (!is_notification(method)) body["id"] = next_id_++;
    body["method"] = method;
    if (!params.is_null()) body["params"] = std::move(params);
    return lsp::frame(in_folder(body.dump()));
  }

  std::string in_folder(std::string text) const {
    for (std::size_t at = 0; (at = text.find(kFolder, at)) != std::string::npos; at += folder_.size()) {
      text.replace(at, kFolder.size(), folder_);
    }
    return text;
  }

  static std::string reply(std::string_view line) {
    const std::string id = take_word(line);
    return lsp::frame(json({{"jsonrpc", "2.0"}, {"id", json::parse(id)}, {"result", json::parse(line)}}).dump());
  }

  std::string open(const std::string& name, const std::string& text) {
    versions_[name] = 1;
    json opened = document(name);
    const char* const language = name.ends_with(".md") ? "markdown" : "latex";
    opened.update({{"languageId", language}, {"version", 1}, {"text", text}});
    return message("textDocument/didOpen", {{"textDocument", opened}});
  }

  std::string change(std::string_view line) {
    const std::string name = take_word(line);
    json changed;
    if (!line.starts_with('"')) changed["range"] = read_range(take_word(line));
    changed["text"] = json::parse(line);
    json versioned = document(name);
    versioned["version"] = ++versions_[name];
    return message("textDocument/didChange", {{"textDocument", versioned}, {"contentChanges", json::array({changed})}});
  }

  const std::string folder_;
  int next_id_ = 0;
  std::map<std::string, int> versions_;
};

// --- what the server says ---

bool is_position(const json& value) {
  return value.is_object() && value.size() == 2 && value.contains("line") && value.contains("character");
}

std::string position_text(const json& position) {
  return fmt::format("{}:{}", position["line"].get<uint64_t>() + 1, position["character"].get<uint64_t>() + 1);
}

json normalised(const json& value, const std::string& folder) {
  if (value.is_string()) {
    const auto text = value.get<std::string>();
    return text.starts_with(folder + "/") ? text.substr(folder.size() + 1) : text;
  }
  if (value.is_object() && value.size() == 2 && value.contains("start") && is_position(value["start"])) {
    return position_text(value["start"]) + "-" + position_text(value["end"]);
  }
  if (!value.is_structured()) return value;
  json result = value.is_object() ? json::object() : json::array();
  for (const auto& [key, element] : value.items()) {
    if (value.is_array()) {
      result.push_back(normalised(element, folder));
    } else if (key.starts_with(folder)) {
      result[std::string(kFolder) + key.substr(folder.size())] = normalised(element, folder);
    } else {
      result[key] = normalised(element, folder);
    }
  }
  return result;
}

bool is_number(const json& value) {
  return value.is_number();
}

/// On one line where it fits, else broken up; numbers are not worth a line each.
void print(std::string& out, const json& value, std::size_t indent) {
  const std::string line = value.dump();
  const bool numbers = value.is_array() && std::all_of(value.begin(), value.end(), is_number);
  if (!value.is_structured() || numbers || indent + line.size() <= kLineWidth) {
    out += line;
    return;
  }
  const std::string inner(indent + 2, ' ');
  const char* separator = "\n";
  out += value.is_object() ? "{" : "[";
  for (const auto& [key, element] : value.items()) {
    out += separator + inner + (value.is_object() ? json(key).dump() + ": " : "");
    print(out, element, indent + 2);
    separator = ",\n";
  }
  out += "\n" + std::string(indent, ' ') + (value.is_object() ? "}" : "]");
}

/// The answer to `client` is the same in every transcript but for the encoding.
json abbreviated(const json& message) {
  const auto encoding = json::json_pointer("/result/capabilities/positionEncoding");
  if (!message.contains(encoding)) return message;
  return {{"id", message["id"]}, {"positionEncoding", message[encoding]}};
}

std::string shown(std::string_view body, bool abbreviate, const std::string& folder) {
  json message = json::parse(body);
  message.erase("jsonrpc");
  if (abbreviate) message = abbreviated(message);
  std::string text = "<- ";
  print(text, normalised(message, folder), 3);
  return text + "\n";
}

std::string shown_all(const std::string& stream, bool abbreviate, const std::string& folder) {
  lsp::FrameDecoder decoder;
  decoder.input() = stream;
  std::string result;
  while (auto next = decoder.next()) result += shown(std::get<lsp::Frame>(*next).body, abbreviate, folder);
  if (decoder.inside_message()) throw std::runtime_error("the server sent something that is no message");
  return result;
}

// --- the transcript ---

/// A folder with the files of one transcript. It is made when the first file is.
class Disk {
 public:
  Disk() = default;
  Disk(const Disk&) = delete;
  Disk& operator=(const Disk&) = delete;
  ~Disk() {
    if (!root_.empty()) std::filesystem::remove_all(root_);
  }

  void make() {
    std::string name = (std::filesystem::temp_directory_path() / "texbrdf-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for the files of a transcript");
    root_ = std::filesystem::canonical(name);
    std::filesystem::create_directory(folder());
  }
  std::filesystem::path folder() const { return root_ / "work"; }
  std::string uri() const { return root_.empty() ? std::string(kFolder) : "file://" + folder().string(); }

  /// One of the lines `file`, `remove` and `link`.
  void obey(std::string_view line, const std::string& text) const {
    const std::string verb = take_word(line);
    const std::filesystem::path path = folder() / take_word(line);
    std::filesystem::create_directories(path.parent_path());
    if (verb == "remove") {
      std::filesystem::remove(path);
    } else if (verb == "link") {
      std::filesystem::create_symlink(std::string(line), path);
    } else {
      std::ofstream(path, std::ios::binary) << text;
    }
  }

 private:
  std::filesystem::path root_;
};

bool is_about_disk(std::string_view line) {
  const std::string verb = take_word(line);
  return verb == "file" || verb == "remove" || verb == "link";
}

/// Lines of the transcript that belong together, and the bytes to send; the answers come behind them.
struct Step {
  std::string lines;
  std::string bytes;
  std::vector<std::pair<std::string, std::string>> disk;  ///< lines about files, and their texts, that come before
};

bool is_answer(const std::string& line) {
  return line.starts_with("<- ") || line.starts_with("   ") || line.starts_with("=> ");
}

std::vector<Step> steps_of(std::string_view transcript, const std::string& folder) {
  std::vector<std::string> lines = lines_of(transcript);
  std::erase_if(lines, is_answer);
  std::vector<Step> steps;
  Client client(folder);
  std::vector<std::pair<std::string, std::string>> disk;
  for (std::size_t i = 0; i < lines.size();) {
    const std::string& line = lines[i++];
    const bool comment = line.empty() || line.starts_with("#");
    const bool joined = line.starts_with("+") && !steps.empty();
    if (!joined) steps.emplace_back();
    Step& step = steps.back();
    step.lines += line + "\n";
    std::string text;
    for (; i < lines.size() && lines[i].starts_with("|"); ++i) {
      step.lines += lines[i] + "\n";
      text += (text.empty() ? "" : "\n") + lines[i].substr(std::min<std::size_t>(2, lines[i].size()));
    }
    if (comment) continue;
    if (is_about_disk(line)) disk.emplace_back(line, text);
    step.bytes += client.bytes_of(line, text);
    if (!step.bytes.empty()) step.disk = std::exchange(disk, {});
  }
  return steps;
}

}  // namespace

std::string play(std::string_view transcript) {
  Disk disk;
  if (transcript.starts_with("file ") || transcript.find("\nfile ") != std::string_view::npos) disk.make();
  const std::vector<Step> steps = steps_of(transcript, disk.uri());
  MemoryChannel channel;
  for (const Step& step : steps) {
    if (step.bytes.empty()) continue;
    channel.add(step.bytes, [&] {
      for (const auto& [line, text] : step.disk) disk.obey(line, text);
    });
  }
  lsp::Log log(lsp::LogLevel::Error, [](std::string_view) {});
  const int status = lsp::run_server(channel, log, {.version = "0.0", .docs_url = "docs", .starts_threads = false});

  std::string result;
  std::size_t answered = 0;
  for (const Step& step : steps) {
    result += step.lines;
    if (step.bytes.empty() || answered == channel.replies().size()) continue;
    result += shown_all(channel.replies()[answered++], step.lines.starts_with("client"), disk.uri());
  }
  return result + fmt::format("=> exit status {}\n", status);
}

}  // namespace texbrdf::test
