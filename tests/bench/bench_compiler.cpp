#include <benchmark/benchmark.h>

#include <optional>
#include <string>

#include "analysis/document.h"
#include "support/renamed_model.h"
#include "syntax/parsed_block.h"

namespace texbrdf {
namespace {

constexpr int kCopies = 10'000;

const std::string& large_document() {
  static const std::string document = test::renamed_copies(test::read_model("cook-torrance"), kCopies);
  return document;
}

void count_work(benchmark::State& state, size_t equations, size_t bytes) {
  const auto runs = static_cast<double>(state.iterations());
  state.counters["equations"] = benchmark::Counter(static_cast<double>(equations) * runs, benchmark::Counter::kIsRate);
  state.SetBytesProcessed(static_cast<int64_t>(bytes) * state.iterations());
}

void scan(benchmark::State& state) {
  const std::string& document = large_document();
  size_t blocks = 0;
  for (auto _ : state) {
    blocks = scan_blocks(document).size();
    benchmark::DoNotOptimize(blocks);
  }
  count_work(state, blocks, document.size());
}
BENCHMARK(scan)->Unit(benchmark::kMillisecond);

void lex_and_parse(benchmark::State& state) {
  const std::string& document = large_document();
  const std::vector<BlockExtent> blocks = scan_blocks(document);
  for (auto _ : state) {
    for (const BlockExtent& block : blocks) {
      ParsedBlock parsed = parse_block(std::string_view(document).substr(block.whole.begin, block.whole.size()), block);
      benchmark::DoNotOptimize(parsed);
    }
  }
  count_work(state, blocks.size(), document.size());
}
BENCHMARK(lex_and_parse)->Unit(benchmark::kMillisecond);

/// From the text to all diagnostics.
void check(benchmark::State& state) {
  const std::string& document = large_document();
  size_t definitions = 0;
  for (auto _ : state) {
    std::optional<Document> checked(document);
    const Snapshot& snapshot = checked->snapshot();
    definitions = snapshot.definitions().size();
    benchmark::DoNotOptimize(snapshot.diagnostics());
    state.PauseTiming();
    checked.reset();
    state.ResumeTiming();
  }
  count_work(state, definitions, document.size());
}
BENCHMARK(check)->Unit(benchmark::kMillisecond);

/// A paper without one equation: what prose costs.
void scan_prose(benchmark::State& state) {
  constexpr size_t kBytes = 100'000'000;
  constexpr std::string_view kLine = "Prose with \\emph{words} in it, costs of 5\\% and $x$ in line. % and a comment\n";
  std::string document;
  while (document.size() < kBytes) document += kLine;
  for (auto _ : state) benchmark::DoNotOptimize(scan_blocks(document));
  count_work(state, 0, document.size());
}
BENCHMARK(scan_prose)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace texbrdf
