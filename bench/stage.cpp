#include "bench/stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <utility>

#include "bench/checks.h"
#include "bench/peers/peers.h"

namespace sightline::bench {
namespace {

struct Elapsed {
  double real;
  double own;  ///< Of this thread on a processor.
};

Elapsed elapsed_by(const auto& work) {
  const auto own_seconds = [] {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  };
  const auto start = std::chrono::steady_clock::now();
  const double own_start = own_seconds();
  work();
  const double own = own_seconds() - own_start;
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), own};
}

bool is_closest(Workload workload) { return workload != Workload::shadow; }

/// How often, and in how many rounds, something that takes `pass_seconds` is run.
void schedule(Measurement& own, double pass_seconds, double slot, double budget, int rounds, int fewest_rounds) {
  own.pass_seconds = pass_seconds;
  own.iterations = static_cast<int>(std::clamp(std::ceil(slot / pass_seconds), 1.0, 1e6));
  const double affordable = std::clamp(budget / (own.iterations * pass_seconds), 0.0, static_cast<double>(rounds));
  own.rounds = std::min(rounds, std::max(fewest_rounds, static_cast<int>(affordable)));
  own.round_seconds.assign(static_cast<std::size_t>(rounds), std::numeric_limits<double>::quiet_NaN());
}

/// The registry's first structure that divides anything; all of ours are compared with it.
std::string_view reference_name() {
  for (const AcceleratorInfo& info : accelerator_infos()) {
    if (info.name != oracle_name) return info.name;
  }
  return oracle_name;
}

}  // namespace

Contenders make_contenders(const Plan& plan) {
  Contenders contenders;
  for (const AcceleratorSpec& choice : plan.structures) {
    AcceleratorSpec spec = choice;
    spec.settings.threads = plan.threads;
    contenders.push_back(make_structure(std::move(spec), plan.asking));
    if (choice.label == plan.spoiled) contenders.back() = spoil(std::move(contenders.back()));
  }
  for (const PeerInfo& info : peer_infos()) {
    if (std::find(plan.peers.begin(), plan.peers.end(), info.name) == plan.peers.end()) continue;
    if (!info.make) throw std::invalid_argument("peer " + std::string(info.name) + " is not part of this build");
    contenders.push_back(info.make(plan.threads));
  }
  return contenders;
}

Stage::Stage(const Plan& plan, const std::string& scene, std::shared_ptr<const TriangleMesh> mesh,
             const Contenders& contenders, Progress& progress)
    : plan_(plan), mesh_(std::move(mesh)), contenders_(contenders), few_rays_(contenders.size()) {
  report_.name = scene;
  report_.triangles = mesh_->size();
  build_all(progress);

  progress.say(report_.name + ": making rays");
  TracerSettings settings;
  settings.threads = plan_.threads;
  // One by one, whatever is measured; rays are the same at every level.
  const auto build = [&](std::string_view name, Level level) {
    return make_structure({"", std::string(name), settings}, {level, false})->build(mesh_);
  };
  auto reference = build(reference_name(), Level::watertight);
  rays_ = make_rays(*mesh_, plan_.rays_of(scene), [&](auto rays, auto hits) { reference->closest_hits(rays, hits); });
  if (plan_.asking.level != Level::watertight) reference = build(reference_name(), plan_.asking.level);
  const auto oracle = build(oracle_name, plan_.asking.level);
  std::size_t most = 0;
  for (const auto& rays : rays_) most = std::max(most, rays.size());
  hits_.resize(most);
  is_hit_.resize(most);
  // A structure that is only built has to be a right one all the same.
  const bool is_built_only = plan_.workloads == std::vector{Workload::build};
  for (const Workload workload : is_built_only ? std::vector{Workload::primary} : plan_.workloads) {
    if (workload == Workload::build) continue;
    if (is_closest(workload)) {
      verify<Hit<float>>(workload, *reference, *oracle, progress);
    } else {
      verify<std::uint8_t>(workload, *reference, *oracle, progress);
    }
  }
  for (std::size_t c = 0; c < contenders_.size(); ++c) {
    report_.contenders[c].bytes = built_[c]->bytes();
    if (is_built_only) report_.contenders[c].at[index_of(Workload::primary)].reset();
  }
}

void Stage::build_all(Progress& progress) {
  for (std::size_t c = 0; c < contenders_.size(); ++c) {
    const Contender& contender = *contenders_[c];
    progress.say(report_.name + ": building " + contender.name());
    const double seconds = elapsed_by([&] { built_.push_back(contender.build(mesh_)); }).real;
    first_build_seconds_.push_back(seconds);
    ContenderReport report;
    report.name = contender.name();
    report.kind = contender.kind();
    report.is_asked_fewer = is_asked_fewer(c);
    if (const AcceleratorSpec* spec = contender.spec()) {
      report.accelerator = spec->accelerator;
      report.options = spec->settings.options;
    }
    report.bytes_when_built = built_[c]->bytes().total();
    if (plan_.has(Workload::build)) {
      Measurement& own = report.at[index_of(Workload::build)].emplace();
      own.rays = 1;
      own.first_pass_seconds = seconds;
      schedule(own, seconds, plan_.slot_seconds, plan_.build_seconds, plan_.rounds, 1);
    }
    report_.contenders.push_back(std::move(report));
  }
}

template <class Answer>
void Stage::verify(Workload workload, const Built& reference, const Built& oracle, Progress& progress) {
  const std::size_t w = index_of(workload);
  const std::span<const Ray<float>> rays = rays_[w];
  const auto affordable = [](double tests, double tests_per_ray) {
    return static_cast<std::size_t>(std::max(16.0, tests / std::max(1.0, tests_per_ray)));
  };

  const std::string place = report_.name + ' ' + std::string(workload_infos[w].name);
  progress.say("verifying " + place + ": " + std::string(oracle_name));
  const std::vector<std::size_t> sample = pick(rays.size(), affordable(plan_.oracle_tests, mesh_->size()));
  report_.sampled_rays = std::max(report_.sampled_rays, sample.size());
  const Checks<Answer> checks(place, *mesh_, rays, reference, oracle, sample);

  std::vector<Answer> answers, counted_answers;
  for (std::size_t c = 0; c < contenders_.size(); ++c) {
    const Contender& contender = *contenders_[c];
    progress.say("verifying " + place + ": " + contender.name());
    Measurement& own = report_.contenders[c].at[w].emplace();
    std::vector<std::size_t> few;
    if (is_asked_fewer(c)) few = pick(rays.size(), affordable(plan_.few_tests, contender.tests_per_ray(mesh_->size())));
    for (const std::size_t i : few) few_rays_[c][w].push_back(rays[i]);
    const std::span<const Ray<float>> own_rays = rays_of(c, workload);
    own.rays = own_rays.size();
    own.hit_share = checks.hit_share();
    answers.assign(own_rays.size(), Answer{});
    const Elapsed first = elapsed_by([&] { ask(*built_[c], own_rays, std::span<Answer>(answers)); });
    own.first_pass_seconds = own.next_pass_seconds = first.real;
    double pass_seconds = first.own;
    if (contender.kind() == Contender::Kind::peer) {
      own.disagreeing_rays = checks.disagreeing(answers, few);
    } else {
      checks.require_right(contender.name(), answers, few);
      counted_answers.assign(own_rays.size(), Answer{});
      const Elapsed next =
          elapsed_by([&] { own.stats = count(*built_[c], own_rays, std::span<Answer>(counted_answers)); });
      own.next_pass_seconds = next.real;
      pass_seconds = std::min(pass_seconds, next.own);
      checks.require_right(contender.name() + " (while counting)", counted_answers, few);
    }
    if (own.rays > 0) {
      schedule(own, pass_seconds, plan_.slot_seconds, plan_.ray_seconds, plan_.rounds, fewest_ray_rounds);
    }
  }
}

std::span<const Ray<float>> Stage::rays_of(std::size_t c, Workload workload) const {
  return (is_asked_fewer(c) ? few_rays_[c] : rays_)[index_of(workload)];
}

void Stage::trace(std::size_t c, Workload workload) {
  const std::span<const Ray<float>> rays = rays_of(c, workload);
  if (is_closest(workload)) {
    ask(*built_[c], rays, std::span(hits_).first(rays.size()));
  } else {
    ask(*built_[c], rays, std::span(is_hit_).first(rays.size()));
  }
}

}  // namespace sightline::bench
