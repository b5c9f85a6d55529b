#include "bench/rounds.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>

#include "bench/rotation.h"

namespace sightline::bench {
namespace {

/// One timed run: a contender's share of a round.
struct Slot {
  std::size_t stage;
  std::size_t contender;
  Workload workload;
  std::size_t round;
  double expected_seconds;
};

void time_build(benchmark::State& state, const Stage& stage, std::size_t contender) {
  for (auto _ : state) {
    std::unique_ptr<Built> built = stage.build(contender);
    benchmark::DoNotOptimize(built);
    state.PauseTiming();
    built.reset();
    state.ResumeTiming();
  }
}

void time_trace(benchmark::State& state, Stage& stage, std::size_t contender, Workload workload) {
  for (auto _ : state) {
    stage.trace(contender, workload);
    benchmark::ClobberMemory();
  }
  const double rays = static_cast<double>(stage.report().contenders[contender].at[index_of(workload)]->rays);
  state.counters["rays"] = benchmark::Counter(rays, benchmark::Counter::kIsIterationInvariantRate);
}

/// Takes Google Benchmark's results down into the reports.
class Recorder final : public benchmark::BenchmarkReporter {
 public:
  Recorder(std::vector<Stage>& stages, Progress& progress, const std::function<void(const SceneReport&)>& see)
      : stages_(stages), progress_(progress), see_(see) {}

  void expect(const std::string& name, const Slot& slot) {
    slots_[name] = slot;
    all_seconds_ += slot.expected_seconds;
  }

  bool ReportContext(const Context&) override {
    start_ = std::chrono::steady_clock::now();
    return true;
  }

  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
      const auto found = slots_.find(run.run_name.function_name);
      if (found == slots_.end()) continue;
      const Slot& slot = found->second;
      if (slot.stage != current_) finish_stages_before(slot.stage);
      const bool is_build = slot.workload == Workload::build;
      const double total = is_build ? run.real_accumulated_time : run.cpu_accumulated_time;
      const double seconds = total / static_cast<double>(run.iterations);
      double& kept = stages_[slot.stage]
                         .report()
                         .contenders[slot.contender]
                         .at[index_of(slot.workload)]
                         ->round_seconds[slot.round];
      kept = std::fmin(kept, seconds);  // of the flag's repetitions, the least disturbed one; NaN before the first
      ++count_;
      done_seconds_ += slot.expected_seconds;
      const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
      const double left = elapsed * (all_seconds_ / done_seconds_ - 1);
      progress_.say("timing", found->first + ", " + std::to_string(count_) + " of " + std::to_string(slots_.size()) +
                                  ", about " + std::to_string(static_cast<int>(std::ceil(std::max(0.0, left)))) +
                                  " s left");
    }
  }

  void Finalize() override { finish_stages_before(stages_.size()); }
  std::size_t count() const { return count_; }

 private:
  void finish_stages_before(std::size_t end) {
    if (count_ == 0) return;
    for (; current_ < end; ++current_) {
      summarize(stages_[current_].report());
      progress_.clear();
      see_(stages_[current_].report());
    }
  }

  std::vector<Stage>& stages_;
  Progress& progress_;
  const std::function<void(const SceneReport&)>& see_;
  std::map<std::string, Slot> slots_;
  std::size_t current_ = 0;
  std::size_t count_ = 0;
  double all_seconds_ = 0, done_seconds_ = 0;  ///< As planned; the clock tells how long that really takes.
  std::chrono::steady_clock::time_point start_;
};

}  // namespace

void set_google_flags(const std::vector<std::string>& flags) {
  std::vector<std::string> words{"sightline-bench"};
  words.insert(words.end(), flags.begin(), flags.end());
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  int count = static_cast<int>(words.size());
  benchmark::Initialize(&count, arguments.data());
  if (count > 1) {
    throw std::invalid_argument(std::string("unknown flag after --: ") + arguments[1] +
                                "; expected flags of Google Benchmark, as -- --help lists them");
  }
}

std::size_t run_rounds(std::vector<Stage>& stages, const Plan& plan, Progress& progress,
                       const std::function<void(const SceneReport&)>& see) {
  benchmark::ClearRegisteredBenchmarks();
  Recorder recorder(stages, progress, see);
  for (std::size_t s = 0; s < stages.size(); ++s) {
    Stage& stage = stages[s];
    const auto& contenders = stage.report().contenders;
    const Turns turns(contenders.size());
    for (const Workload workload : plan.workloads) {
      for (std::size_t round = 0; round < static_cast<std::size_t>(plan.rounds); ++round) {
        for (std::size_t i = 0; i < contenders.size(); ++i) {
          const std::size_t c = turns.line(round, i);
          const Measurement& own = *contenders[c].at[index_of(workload)];
          if (round >= static_cast<std::size_t>(own.rounds)) continue;
          const std::string name = stage.report().name + '/' + std::string(workload_infos[index_of(workload)].name) +
                                   '/' + contenders[c].name + "/round:" + std::to_string(round + 1);
          auto* const entry =
              benchmark::RegisterBenchmark(name.c_str(), [&stage, c, workload](benchmark::State& state) {
                workload == Workload::build ? time_build(state, stage, c) : time_trace(state, stage, c, workload);
              });
          entry->Iterations(own.iterations)->UseRealTime()->Unit(benchmark::kMillisecond);
          recorder.expect(name, {s, c, workload, round, own.iterations * own.pass_seconds});
        }
      }
    }
  }
  benchmark::RunSpecifiedBenchmarks(&recorder);
  return recorder.count();
}

}  // namespace sightline::bench
