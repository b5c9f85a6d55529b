#include "tests/hard_cases/mesh_question.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "sightline/shape/triangle_crossings.h"

namespace sightline::hard {
namespace {

/// What lib/README.md promises of t, in units of the distance to the farthest part of the scene, beside its rounding to
/// the ray's precision.
constexpr double fast_share = 0x1p-19, double_share = 0x1p-35;

/// The largest distance along an axis from the ray's origin to the mesh.
double reach(const Ray<double>& ray, const Aabb& bounds) {
  double farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double to_lo = std::fabs(double(bounds.lo[axis]) - ray.origin[axis]),
                 to_hi = std::fabs(double(bounds.hi[axis]) - ray.origin[axis]);
    farthest = std::max({farthest, to_lo, to_hi});
  }
  return farthest;
}

template <class T>
T true_t(const TrueCrossing& crossing) {
  if constexpr (std::is_same_v<T, float>)
    return crossing.t_float;
  else
    return crossing.t;
}

template <class T>
std::string text_of_hit(const Hit<T>& hit) {
  return hit.is_hit() ? "triangle " + std::to_string(hit.prim_id) + " at " + text_of_number(double(hit.t)) : "none";
}

}  // namespace

std::string text_of_number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.17g", x);
  return text;
}
std::string text_of_point(const Vec3d& p) {
  return "(" + text_of_number(p.x) + ", " + text_of_number(p.y) + ", " + text_of_number(p.z) + ")";
}
std::string text_of_ray(const Ray<double>& ray) {
  return "from " + text_of_point(ray.origin) + " along " + text_of_point(ray.direction);
}

TracedMesh::TracedMesh(TriangleMesh mesh) : mesh_(std::make_shared<const TriangleMesh>(std::move(mesh))) {
  TracerSettings settings;
  settings.threads = 1;
  for (const AcceleratorInfo& info : accelerator_infos()) tracers_.push_back(make_tracer(info.name, mesh_, settings));
}

MeshQuestion::MeshQuestion(const TriangleMesh& mesh, std::vector<Ray<float>> rays)
    : mesh_(mesh), rays_(std::move(rays)) {
  for (const Ray<float>& ray : rays_) {
    wide_.push_back(to_double(ray));
    truths_.push_back(true_crossings(mesh, wide_.back()));
  }
}

std::size_t MeshQuestion::hits() const {
  return static_cast<std::size_t>(std::ranges::count_if(truths_, [](const auto& truth) { return !truth.empty(); }));
}

template <class Got>
Example MeshQuestion::example(std::size_t i, Got&& got) const {
  const auto& truth = truths_[i];
  std::string expected = "none";
  if (!truth.empty()) {
    expected = "triangle " + std::to_string(truth[0].id) + " at " + text_of_number(truth[0].t);
    const auto others = std::ranges::count(truth, 0u, &TrueCrossing::rank) - 1;
    if (others > 0) expected += ", and " + std::to_string(others) + " more there";
  }
  return {text_of_ray(wide_[i]), expected, got()};
}

template <class T>
Judged MeshQuestion::judged(std::size_t i, const Hit<T>& hit, double share) const {
  const auto& truth = truths_[i];
  if (truth.empty() || !hit.is_hit()) return {truth.empty() == !hit.is_hit() ? Verdict::exact : Verdict::wrong, 0};
  const auto it = std::ranges::find(truth, hit.prim_id, &TrueCrossing::id);
  const double nearest = truth[0].t, error = std::fabs(double(hit.t) - nearest);
  const double relative = error / std::fabs(nearest);
  if (it == truth.end()) return {Verdict::wrong, relative};
  if (it->rank == 0 && hit.t == true_t<T>(truth[0])) return {Verdict::exact, relative};
  const double ulp = double(std::nextafter(std::fabs(hit.t), std::numeric_limits<T>::infinity())) - std::fabs(hit.t);
  const double bound = share * reach(wide_[i], mesh_.bounds()) / max_norm(wide_[i].direction) + ulp;
  const bool is_near = error <= bound && std::fabs(it->t - nearest) <= 2 * bound;
  return {is_near ? Verdict::within_bound : Verdict::wrong, relative};
}

template <class T>
void MeshQuestion::judge_closest(Tally& tally, std::size_t i, const Hit<T>& hit, double share) const {
  const Judged found = judged(i, hit, share);
  tally.add(found.verdict, found.error, [&] { return example(i, [&] { return text_of_hit(hit); }); });
}

void MeshQuestion::judge_any(Tally& tally, std::size_t i, bool is_hit) const {
  tally.decide(is_hit == !truths_[i].empty(),
               [&] { return example(i, [&] { return is_hit ? "any hit: yes" : "any hit: no"; }); });
}

void MeshQuestion::judge(Tally& tally, std::size_t i, const Hit<float>& hit) const {
  judge_closest(tally, i, hit, fast_share);
}

void MeshQuestion::judge_exact(Tally& tally, std::size_t i, const Hit<double>& hit,
                               const std::vector<Hit<double>>& all) const {
  const auto& truth = truths_[i];
  std::vector<std::uint32_t> found, expected;
  for (const Hit<double>& one : all) found.push_back(one.prim_id);
  for (const TrueCrossing& one : truth) expected.push_back(one.id);
  std::ranges::sort(found), std::ranges::sort(expected);
  const auto met = std::ranges::find(truth, hit.prim_id, &TrueCrossing::id);
  const bool is_nearest =
      met == truth.end() ? truth.empty() && !hit.is_hit() : hit.t == truth[0].t && met->t == truth[0].t;
  tally.decide(found == expected && is_nearest, [&] {
    return example(i, [&] {
      return text_of_hit(hit) + ", " + std::to_string(found.size()) + " crossed of " + std::to_string(expected.size());
    });
  });
}

template <class T>
void MeshQuestion::ask_numbers(Trial& trial, const Tracer& tracer, std::span<const Ray<T>> rays, Level level,
                               double share) const {
  std::vector<Hit<T>> hits(rays.size()), streamed(rays.size());
  std::vector<std::uint8_t> any(rays.size());
  tracer.closest_hits(rays, hits, level);
  tracer.stream_closest_hits(rays, streamed, level);
  tracer.any_hits(rays, any, level);
  Tally& tally = trial.of(tracer.name(), level);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    judge_closest(tally, i, hits[i], share);
    if (!(streamed[i] == hits[i])) judge_closest(tally, i, streamed[i], share);
    judge_any(tally, i, any[i] != 0);
  }
}

void MeshQuestion::ask_crossings(Trial& trial) const {
  const std::vector<Vec3d> vertices(mesh_.positions().begin(), mesh_.positions().end());
  Tally& tally = trial.of("triangle-crossings", Level::exact);
  for (std::size_t i = 0; i < wide_.size(); ++i) {
    const double t_min = std::max(wide_[i].t_min, 0.0);  // it looks no farther back
    const auto found = triangle_crossings(FramedRay(wide_[i]), vertices, mesh_.triangles());
    std::vector<std::pair<double, std::uint32_t>> flat, expected;
    for (const TriangleCrossing& crossing : found) {
      if (!(crossing.t > t_min && crossing.t <= wide_[i].t_max)) continue;
      for (const std::uint32_t id : crossing.triangles) flat.emplace_back(crossing.t, id);
    }
    for (const TrueCrossing& one : truths_[i]) {
      if (one.t > t_min) expected.emplace_back(one.t, one.id);
    }
    tally.decide(flat == expected, [&] {
      return example(i, [&] {
        return flat.empty() ? "none"
                            : "triangle " + std::to_string(flat[0].second) + " at " + text_of_number(flat[0].first) +
                                  ", " + std::to_string(flat.size()) + " in all";
      });
    });
  }
}

void MeshQuestion::ask(Trial& trial, const TracedMesh& traced) const {
  for (const auto& tracer : traced.tracers()) {
    ask_numbers<float>(trial, *tracer, rays_, Level::fast, fast_share);
    ask_numbers<float>(trial, *tracer, rays_, Level::watertight, double_share);
    ask_numbers<double>(trial, *tracer, wide_, Level::precise, double_share);
    Tally& exact = trial.of(tracer->name(), Level::exact);
    std::vector<Hit<double>> hits(wide_.size());
    tracer->closest_hits(std::span<const Ray<double>>(wide_), hits, Level::exact);
    for (std::size_t i = 0; i < wide_.size(); ++i) judge_exact(exact, i, hits[i], tracer->all_hits(wide_[i]));
  }
  ask_crossings(trial);
}

void MeshQuestion::ask(Tally& tally, NaiveTest test) const {
  for (std::size_t i = 0; i < rays_.size(); ++i) {
    Hit<float> best;
    for (std::uint32_t id = 0; id < mesh_.size(); ++id) {
      const std::optional<float> t = test(rays_[i], mesh_[id]);
      if (t && *t > rays_[i].t_min && *t <= rays_[i].t_max && *t < best.t) best = {*t, id, 0, 0};
    }
    judge(tally, i, best);
  }
}

}  // namespace sightline::hard
