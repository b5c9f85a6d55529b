#include "bench/stage.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <utility>

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

/// How many rays may be asked where a ray takes so many tests.
std::size_t affordable(double tests, double tests_per_ray) {
  return static_cast<std::size_t>(std::max(16.0, tests / std::max(1.0, tests_per_ray)));
}

/// What all of ours are compared with: soon built, and not slow even where bounding volumes collapse.
constexpr std::string_view reference_name = "wide-tree";

bool can_stream(const AcceleratorSpec& spec) {
  const auto infos = accelerator_infos();
  return std::any_of(infos.begin(), infos.end(),
                     [&](const AcceleratorInfo& info) { return info.name == spec.accelerator && info.can_stream; });
}

}  // namespace

std::vector<Asking> askings_of(const Plan& plan, const AcceleratorSpec& spec) {
  std::vector<Asking> askings;
  for (const Level level : plan.levels) {
    askings.push_back({level, false});
    if (plan.is_stream && can_stream(spec)) askings.push_back({level, true});
  }
  return askings;
}

Contenders make_contenders(const Plan& plan) {
  Contenders contenders;
  for (const AcceleratorSpec& choice : plan.structures) {
    AcceleratorSpec spec = choice;
    spec.settings.threads = plan.threads;
    for (const Asking& asking : askings_of(plan, spec)) {
      contenders.push_back(make_structure(spec, asking));
      if (contenders.back()->name() == plan.spoiled) contenders.back() = spoil(std::move(contenders.back()));
    }
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

  progress.say(report_.name + ": building what hits are held against");
  TracerSettings settings;
  settings.threads = plan_.threads;
  const auto build = [&](std::string_view name) {
    return make_structure({"", std::string(name), settings})->build(mesh_);
  };
  const auto reference = build(reference_name), oracle = build(oracle_name);
  progress.say(report_.name + ": making rays");
  rays_ = make_rays(*mesh_, plan_.rays_of(scene), [&](auto rays, auto hits) { reference->closest_hits(rays, hits); });
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
    ContenderReport report;
    report.built_as = built_as(c);
    if (report.built_as) {
      built_.push_back(contender.share(*built_[*report.built_as]));
      first_build_seconds_.push_back(first_build_seconds_[*report.built_as]);
    } else {
      progress.say(report_.name + ": building " + contender.name());
      first_build_seconds_.push_back(elapsed_by([&] { built_.push_back(contender.build(mesh_)); }).real);
    }
    report.name = contender.name();
    report.kind = contender.kind();
    report.is_asked_fewer = is_asked_fewer(c);
    if (const AcceleratorSpec* spec = contender.spec()) {
      report.accelerator = spec->accelerator;
      report.options = spec->settings.options;
      report.asking = *contender.asking();
      report.level = built_[c]->level();
    }
    report.bytes_when_built = built_[c]->bytes().total();
    if (plan_.has(Workload::build)) {
      Measurement& own = report.at[index_of(Workload::build)].emplace();
      own.rays = 1;
      own.first_pass_seconds = first_build_seconds_[c];
      schedule(own, first_build_seconds_[c], plan_.slot_seconds, plan_.build_seconds, plan_.rounds, 1);
      if (report.built_as) own.rounds = 0;
    }
    report_.contenders.push_back(std::move(report));
  }
}

std::optional<std::size_t> Stage::built_as(std::size_t c) const {
  const AcceleratorSpec* spec = contenders_[c]->spec();
  for (std::size_t earlier = 0; spec && earlier < c; ++earlier) {
    const AcceleratorSpec* other = contenders_[earlier]->spec();
    if (other && other->label == spec->label) return earlier;
  }
  return std::nullopt;
}

template <class Answer>
void Stage::verify(Workload workload, const Built& reference, const Built& oracle, Progress& progress) {
  const std::size_t w = index_of(workload);
  const std::vector<std::size_t> sample = pick(rays_[w].size(), affordable(plan_.oracle_tests, mesh_->size()));
  report_.sampled_rays = std::max(report_.sampled_rays, sample.size());
  const std::string place = report_.name + ' ' + std::string(workload_infos[w].name);
  for (const Level level : {Level::watertight, Level::fast}) {
    std::vector<std::size_t> held;
    for (std::size_t c = 0; c < contenders_.size(); ++c) {
      if (report_.contenders[c].level == level) held.push_back(c);
    }
    if (held.empty()) continue;
    progress.say("verifying " + place + ": " + name_of(std::string(oracle_name), {level}));
    const auto own_reference = reference.asked({level}), own_oracle = oracle.asked({level});
    const Checks<Answer> checks(place, *mesh_, rays_[w], *own_reference, *own_oracle, sample);
    for (const std::size_t c : held) {
      progress.say("verifying " + place + ": " + contenders_[c]->name());
      verify_one(c, workload, checks);
    }
  }
}

template <class Answer>
void Stage::verify_one(std::size_t c, Workload workload, const Checks<Answer>& checks) {
  const Contender& contender = *contenders_[c];
  const std::vector<Ray<float>>& rays = rays_[index_of(workload)];
  Measurement& own = report_.contenders[c].at[index_of(workload)].emplace();
  std::vector<std::size_t> few;
  if (is_asked_fewer(c)) few = pick(rays.size(), affordable(plan_.few_tests, contender.tests_per_ray(mesh_->size())));
  for (const std::size_t i : few) few_rays_[c][index_of(workload)].push_back(rays[i]);
  const std::span<const Ray<float>> own_rays = rays_of(c, workload);
  own.rays = own_rays.size();
  own.hit_share = checks.hit_share();
  std::vector<Answer> answers(own_rays.size());
  const Elapsed first = elapsed_by([&] { ask(*built_[c], own_rays, std::span<Answer>(answers)); });
  own.first_pass_seconds = own.next_pass_seconds = first.real;
  double pass_seconds = first.own;
  if (contender.kind() == Contender::Kind::peer) {
    own.disagreeing_rays = checks.disagreeing(answers, few);
  } else {
    checks.require_right(contender.name(), answers, few);
    answers.assign(own_rays.size(), Answer{});
    const Elapsed next = elapsed_by([&] { own.stats = count(*built_[c], own_rays, std::span<Answer>(answers)); });
    own.next_pass_seconds = next.real;
    pass_seconds = std::min(pass_seconds, next.own);
    checks.require_right(contender.name() + " (while counting)", answers, few);
  }
  if (own.rays > 0) {
    schedule(own, pass_seconds, plan_.slot_seconds, plan_.ray_seconds, plan_.rounds, fewest_ray_rounds);
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
