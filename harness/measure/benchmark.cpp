#include "harness/measure/benchmark.h"

#include <benchmark/benchmark.h>

#include <array>
#include <sstream>
#include <string_view>

#include "harness/base/error.h"
#include "harness/base/process.h"

namespace geodesic::harness {
namespace {

constexpr const char* kCpuElsewhere = "cpu_elsewhere";  // seconds

struct RefusedFlag {
  std::string_view name;
  std::string_view why;
};

constexpr std::array<RefusedFlag, 8> kRefused{{
    {"--benchmark_out", "the run writes its own files"},
    {"--benchmark_out_format", "the run writes its own files"},
    {"--benchmark_format", "the run writes its own files"},
    {"--benchmark_filter", "choose with --solvers and --meshes"},
    {"--benchmark_list_tests", "choose with --solvers and --meshes"},
    {"--benchmark_repetitions", "use --repetitions"},
    {"--benchmark_report_aggregates_only", "every repetition is kept"},
    {"--benchmark_display_aggregates_only", "every repetition is kept"},
}};

// Passes the flags to Google Benchmark and returns those that it does not know.
std::vector<std::string> initialize(std::vector<std::string> flags) {
  static std::string program = "geodesic-bench";  // the library keeps the pointer
  std::vector<char*> argv = argv_of(flags);
  argv.insert(argv.begin(), program.data());
  int argc = static_cast<int>(flags.size()) + 1;
  benchmark::Initialize(&argc, argv.data());
  std::vector<std::string> left;
  for (int i = 1; i < argc; ++i) left.emplace_back(argv[static_cast<std::size_t>(i)]);
  return left;
}

// A reporter and the text that it writes.
class JsonText {
 public:
  JsonText() {
    reporter_.SetOutputStream(&text_);
    reporter_.SetErrorStream(&errors_);
  }
  benchmark::JSONReporter& reporter() { return reporter_; }
  Json parse() const { return Json::parse(text_.str()); }

 private:
  std::ostringstream text_, errors_;
  benchmark::JSONReporter reporter_;
};

}  // namespace

void check_benchmark_flags(const std::vector<std::string>& flags) {
  for (const std::string& flag : flags) {
    for (const RefusedFlag& refused : kRefused) {
      if (flag.substr(0, flag.find('=')) == refused.name) {
        throw HarnessError(std::string(refused.name) +
                           " cannot be used in a run: " + std::string(refused.why));
      }
    }
    if (!flag.starts_with("--benchmark_")) {
      throw HarnessError("'" + flag + "' after -- is not a flag of Google Benchmark");
    }
  }
  const std::vector<std::string> left = initialize(flags);
  if (!left.empty()) {
    throw HarnessError("Google Benchmark does not take '" + left.front() +
                       "'; flags that make sense here: --benchmark_min_time=SECONDS, "
                       "--benchmark_min_warmup_time=SECONDS, --benchmark_perf_counters=NAMES");
  }
}

std::vector<Repetition> time_repetitions(const std::vector<std::string>& flags,
                                         const TimedWork& work) {
  initialize(flags);
  benchmark::ClearRegisteredBenchmarks();
  auto* const timed = benchmark::RegisterBenchmark("solve", [&](benchmark::State& state) {
    double cpu_elsewhere = 0;
    for (auto _ : state) {
      if (work.prepare) {
        state.PauseTiming();
        work.prepare();
        state.ResumeTiming();
      }
      work.solve();
      if (work.elsewhere) {
        const SecondsElsewhere seconds = work.elsewhere();
        state.SetIterationTime(seconds.real);
        cpu_elsewhere += seconds.cpu;
      }
    }
    if (work.elsewhere) {
      state.counters[kCpuElsewhere] = cpu_elsewhere / static_cast<double>(state.iterations());
    }
  });
  timed->Unit(benchmark::kMillisecond);
  // Each solve is a process, so a repetition is one solve, however short.
  if (work.elsewhere) timed->UseManualTime()->Iterations(1);
  if (work.several_threads) timed->MeasureProcessCPUTime()->UseRealTime();
  JsonText out;
  benchmark::RunSpecifiedBenchmarks(&out.reporter());
  std::vector<Repetition> repetitions;
  const Json json = out.parse();
  for (const Json& row : json.at("benchmarks")) {
    if (row.at("run_type") != "iteration") continue;  // an aggregate
    const double cpu_ms = work.elsewhere ? 1e3 * row.at(kCpuElsewhere).get<double>()
                                         : row.at("cpu_time").get<double>();
    repetitions.push_back({row.at("iterations"), row.at("real_time"), cpu_ms});
  }
  if (repetitions.empty()) throw HarnessError("Google Benchmark timed nothing");
  return repetitions;
}

Json benchmark_context() {
  initialize({});
  JsonText out;
  out.reporter().ReportContext(benchmark::BenchmarkReporter::Context());
  out.reporter().Finalize();
  return out.parse().at("context");
}

}  // namespace geodesic::harness
