// What a user waits for, from the message to the answer: a server on a thread of its own, a channel without pipes.

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/document.h"
#include "render/worker.h"
#include "server_client.h"
#include "support/read_file.h"

namespace texbrdf {
namespace {

using Clock = std::chrono::steady_clock;
using nlohmann::json;

/// Nobody types faster; the GPU's picture of the last key may still be on its way.
constexpr std::chrono::milliseconds kBetweenKeys{60};
constexpr const char* kUri = "file:///bench.tex";

std::string model_text(const std::string& name) {
  return test::read_file(fmt::format("{}/models/{}.tex", TEXBRDF_TEST_DATA, name));
}

void open(test::ServerClient& client, const std::string& text) {
  const json document{{"uri", kUri}, {"languageId", "latex"}, {"version", 1}, {"text", text}};
  client.notify("textDocument/didOpen", json{{"textDocument", document}}.dump());
  client.wait_for("textDocument/publishDiagnostics");
}

json position_of(const std::string& text, std::size_t offset) {
  const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n');
  const std::size_t begin = offset == 0 ? 0 : text.rfind('\n', offset - 1) + 1;
  return {{"line", line}, {"character", offset - begin}};
}

/// Median and 95th percentile, in milliseconds.
void report(benchmark::State& state, std::vector<double>& milliseconds) {
  std::ranges::sort(milliseconds);
  state.counters["median_ms"] = milliseconds[milliseconds.size() / 2];
  state.counters["p95_ms"] = milliseconds[milliseconds.size() * 95 / 100];
}

double milliseconds_since(Clock::time_point begin) {
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

/// Plays the pane, which shows each frame at once, up to the first of the version or for so long.
bool show_frames(test::ServerClient& client, std::string_view version, std::chrono::milliseconds patience) {
  const auto end = Clock::now() + patience;
  while (Clock::now() < end) {
    const auto rest = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
    const std::optional<std::string> message = client.receive(rest);
    if (!message || message->find("texbrdf/frame") == std::string::npos) continue;
    client.notify("texbrdf/frameShown", R"({"preview":1})");
    if (!version.empty() && message->find(version) != std::string::npos) return true;
  }
  return false;
}

void wait_for_frame(test::ServerClient& client, int version) {
  const bool has_come = show_frames(client, fmt::format(R"("version":{},)", version), std::chrono::seconds(30));
  require(has_come, "a frame comes");
}

/// A digit of a number in the model is replaced by another, again and again: `didChange` → first frame.
void edit_to_frame(benchmark::State& state, const std::string& model, const std::string& number) {
  const std::string text = model_text(model);
  test::ServerClient client("{}");
  open(client, text);
  const json place = position_of(text, text.find(number) + number.size() - 1);
  json end = place;
  end["character"] = place["character"].get<int>() + 1;
  const std::string opened =
      client.request("texbrdf/openPreview", json{{"uri", kUri}, {"width", 256}, {"height", 256}}.dump());
  require(opened.find(R"("preview":1)") != std::string::npos, "the first preview is number 1");
  wait_for_frame(client, 1);

  int version = 1;
  std::vector<double> waited;
  for (auto _ : state) {
    state.PauseTiming();
    show_frames(client, {}, kBetweenKeys);
    ++version;
    const json change{{"range", {{"start", place}, {"end", end}}}, {"text", std::to_string(1 + version % 9)}};
    const std::string params =
        json{{"textDocument", {{"uri", kUri}, {"version", version}}}, {"contentChanges", json::array({change})}}.dump();
    state.ResumeTiming();
    const auto begin = Clock::now();
    client.notify("textDocument/didChange", params);
    wait_for_frame(client, version);
    waited.push_back(milliseconds_since(begin));
  }
  report(state, waited);
}

BENCHMARK_CAPTURE(edit_to_frame, blinn_phong, "blinn-phong", "n = +2")->Iterations(100)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(edit_to_frame, cook_torrance, "cook-torrance", "m = 0.13")
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(edit_to_frame, ashikhmin_shirley, "ashikhmin-shirley", "n_u = 300")
    ->Iterations(100)
    ->Unit(benchmark::kMillisecond);

double time_hover(test::ServerClient& client, const std::string& params) {
  constexpr int kRounds = 5;
  std::array<double, kRounds> times{};
  for (double& time : times) {
    const auto begin = Clock::now();
    benchmark::DoNotOptimize(client.request("textDocument/hover", params));
    time = milliseconds_since(begin);
  }
  std::ranges::sort(times);
  return times[kRounds / 2];
}

/// Places where a token of a right side or a defined name begins.
std::vector<std::size_t> hovered_places(const std::string& text) {
  Document document(text);
  const Snapshot& snapshot = document.snapshot();
  std::vector<std::size_t> places;
  for (const Block& block : snapshot.blocks()) {
    for (const Token& token : block.parsed->tokens) places.push_back(block.offset + token.span.begin);
  }
  return places;
}

/// What a picture adds to a hover, at each token of a model: the median of the tokens, and the most.
void hover_picture(benchmark::State& state, const std::string& model) {
  const std::string text = model_text(model);
  test::ServerClient plain(R"({"textDocument":{"hover":{"contentFormat":["markdown"]}}})");
  test::ServerClient drawn(
      R"({"general":{"markdown":{"parser":"any"}},"textDocument":{"hover":{"contentFormat":["markdown"]}}})");
  open(plain, text);
  open(drawn, text);
  std::vector<double> more;
  int pictures = 0;
  std::size_t bytes = 0;
  for (auto _ : state) {
    for (const std::size_t place : hovered_places(text)) {
      const std::string params = json{{"textDocument", {{"uri", kUri}}}, {"position", position_of(text, place)}}.dump();
      const std::string answer = drawn.request("textDocument/hover", params);
      if (answer.find("data:image/png") == std::string::npos) continue;
      ++pictures;
      bytes = std::max(bytes, answer.size());
      more.push_back(time_hover(drawn, params) - time_hover(plain, params));
    }
  }
  report(state, more);
  state.counters["most_ms"] = more.back();
  state.counters["pictures"] = pictures;
  state.counters["bytes"] = static_cast<double>(bytes);
}

void register_hovers() {
  std::vector<std::string> models;
  for (const auto& entry : std::filesystem::directory_iterator(TEXBRDF_TEST_DATA "/models")) {
    if (entry.path().extension() == ".tex") models.push_back(entry.path().stem());
  }
  std::ranges::sort(models);
  for (const std::string& model : models) {
    benchmark::RegisterBenchmark(("hover_picture/" + model).c_str(), hover_picture, model)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace texbrdf

/// As the server's own program, it is also its render worker.
int main(int argc, char** argv) {
  if (argc > 1 && std::string_view(argv[1]) == "render-worker")
    return texbrdf::render::run_render_worker(STDIN_FILENO, STDOUT_FILENO);
  texbrdf::register_hovers();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
