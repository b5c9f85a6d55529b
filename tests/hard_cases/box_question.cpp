#include "tests/hard_cases/box_question.h"

#include <cmath>
#include <limits>

#include "sightline/shape/box.h"
#include "tests/csg/random_solid.h"

namespace sightline::hard {
namespace {

using Rational = boost::multiprecision::cpp_rational;

TriangleMesh mesh_of(std::span<const Aabb> boxes) {
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (const Aabb& box : boxes) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (int corner = 0; corner < 8; ++corner) {
      positions.push_back(
          {corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z});
    }
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t a = 1u << (axis + 1) % 3, b = 1u << (axis + 2) % 3;
      for (const std::uint32_t side : {0u, 1u << axis}) {
        triangles.push_back({first + side, first + side + a, first + side + a + b});
        triangles.push_back({first + side, first + side + a + b, first + side + b});
      }
    }
  }
  return {std::move(positions), std::move(triangles)};
}

std::vector<SolidTree> solids_of(std::span<const Aabb> boxes) {
  std::vector<SolidTree> solids;
  for (const Aabb& box : boxes) solids.emplace_back(solid_of(box));
  return solids;
}

/// What one structure says of the first hit: by the nearest one, and whether there is any.
template <class T>
void judge_triangles(Tally& tally, const Queries<T>& tracer, Level level, const SolidQuestion& question) {
  const Ray<T> ray{Vec3<T>(question.ray().origin), Vec3<T>(question.ray().direction)};
  Hit<T> hit;
  std::uint8_t is_any = 0;
  tracer.closest_hits(std::span(&ray, 1), std::span(&hit, 1), level);
  tracer.any_hits(std::span(&ray, 1), std::span(&is_any, 1), level);
  std::optional<std::size_t> first = question.first_end();
  // A parameter that T has no number for is beyond any ray's range.
  if (first && question.truth().ends[*first](std::numeric_limits<T>::max(), 0) > 0) first.reset();
  Verdict verdict =
      hit.is_hit() == first.has_value() && hit.is_hit() == (is_any != 0) ? Verdict::exact : Verdict::wrong;
  double error = 0;
  if (verdict == Verdict::exact && first) {
    const TrueNumber& truth = question.truth().ends[*first];
    const double t = hit.t, nearest = question.truth().nearest[*first];
    const double share = std::is_same_v<T, float> && level == Level::fast ? 0x1p-19 : 0x1p-35;
    double bound = share * question.reach();
    if (std::is_same_v<T, float> && level != Level::fast) bound += 0x1p-24 * std::fabs(t);
    error = t == nearest ? 0 : std::fabs((t - nearest) / nearest);
    if (!is_nearest(truth, hit.t))
      verdict = truth(t, -bound) >= 0 && truth(t, bound) <= 0 ? Verdict::within_bound : Verdict::wrong;
  }
  tally.add(verdict, error, [&] {
    return Example{"triangles of boxes, " + text_of(question.ray()),
                   first ? all_digits(question.truth().nearest[*first]) : "none",
                   hit.is_hit() ? all_digits(double(hit.t)) : "none"};
  });
}

}  // namespace

solid::Box solid_of(const Aabb& box) { return {Vec3d(box.lo), Vec3d(box.hi)}; }

BoxesByStructure::BoxesByStructure(std::span<const Aabb> boxes) : solids_(solids_of(boxes)) {
  const auto mesh = std::make_shared<const TriangleMesh>(mesh_of(boxes));
  TracerSettings settings;
  settings.threads = 1;
  for (const AcceleratorInfo& info : accelerator_infos()) meshes_.push_back(make_tracer(info.name, mesh, settings));
}

BoxesByStructure boxes_around(const Aabb& box, float apart) {
  std::vector<Aabb> boxes;
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      const Vec3f move = apart * Vec3f(x, y, 0);
      boxes.push_back({box.lo + move, box.hi + move});
    }
  }
  return BoxesByStructure(boxes);
}

void ask_triangles(Trial& trial, const BoxesByStructure& boxes, const SolidQuestion& question) {
  for (const auto& tracer : boxes.meshes()) {
    const std::string_view name = tracer->name();
    for (const Level level : triangle_levels) judge_triangles<float>(trial.of(name, level), *tracer, level, question);
    judge_triangles<double>(trial.of(name, Level::precise), *tracer, Level::precise, question);
  }
}

void ask_structures(Trial& trial, const BoxesByStructure& boxes, const Ray<double>& ray) {
  const SolidQuestion question(boxes.solids().tree(), ray);
  question.ask_spans(trial, boxes.solids());
  ask_triangles(trial, boxes, question);
}

void ask_box_set(Trial& trial, const Aabb& box, const SolidQuestion& question) {
  std::vector<double> ends;
  BoxSet::PreparedRay(question.ray()).for_each_crossing(box, [&](const Crossing& crossing) {
    ends.push_back(crossing.t);
  });
  question.judge_crossings(trial.of("box set"), ends);
}

std::optional<TrueClip> true_clip(const Aabb& box, const Ray<double>& ray) {
  std::optional<TrueClip> clip;
  for (int axis = 0; axis < 3; ++axis) {
    const Rational origin(ray.origin[axis]), direction(ray.direction[axis]);
    const Rational to_lo = Rational(box.lo[axis]) - origin, to_hi = Rational(box.hi[axis]) - origin;
    if (direction == 0) {
      if (to_lo > 0 || to_hi < 0) return std::nullopt;
      continue;
    }
    const Rational a = to_lo / direction, b = to_hi / direction;
    const Rational enter = a < b ? a : b, leave = a < b ? b : a;
    if (!clip) {
      clip = TrueClip{enter, leave};
    } else {
      if (enter > clip->enter) clip->enter = enter;
      if (leave < clip->leave) clip->leave = leave;
    }
  }
  return clip && clip->enter <= clip->leave ? clip : std::nullopt;
}

TrueNumber true_number(const Rational& x) {
  return [x](double a, double b) { return Rational(x - Rational(a) - Rational(b)).sign(); };
}

}  // namespace sightline::hard
