/// What structures are built of: bounds that round, primitives that are all the same, polygons on planes.

#include "sightline/render/solid_tracer.h"
#include "tests/csg/evaluate.h"
#include "tests/hard_cases/accelerator_parts.h"
#include "tests/hard_cases/exact_side.h"

namespace sightline::hard {
namespace {

// ---- bih-clip-round

/// Boxes in double, one above the other, and rays along x that pass within a float's last place of their faces.
void run_clip_round(Trial& trial) {
  Random random(101);
  std::vector<std::shared_ptr<const Solid>> solids;
  std::vector<solid::Box> boxes;
  for (std::uint64_t i = 0; i < trial.count(300); ++i) {
    const Vec3d lo(random.uniform_double(), 4.0 * double(i) + random.uniform_double(), random.uniform_double());
    boxes.push_back({lo, lo + 1.0 + Vec3d(random.uniform_double(), random.uniform_double(), random.uniform_double())});
    solids.push_back(std::make_shared<const Solid>(SolidTree(boxes.back())));
  }
  std::vector<Ray<double>> rays;
  std::vector<std::uint32_t> of;
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    const double lo = boxes[id].lo.y, hi = boxes[id].hi.y;
    // Exactly in the face, a step beside it, and between it and the float next to it.
    for (const double y : {hi, std::nextafter(hi, INFINITY), 0.5 * (hi + double(float(hi))), lo,
                           std::nextafter(lo, -INFINITY), 0.5 * (lo + double(float(lo)))}) {
      rays.push_back({{-1, y, boxes[id].lo.z + 0.5}, {1, 0, 0}});
      of.push_back(id);
    }
  }
  const auto truth = [&](std::size_t i) {
    return rays[i].origin.y >= boxes[of[i]].lo.y && rays[i].origin.y <= boxes[of[i]].hi.y;
  };
  const auto example = [&](std::size_t i, const std::string& got) {
    return Example{
        text_of_ray(rays[i]) + ", box from " + text_of_point(boxes[of[i]].lo) + " to " + text_of_point(boxes[of[i]].hi),
        truth(i) ? "hit at " + text_of_number(boxes[of[i]].lo.x + 1) : "none", got};
  };
  for (const AcceleratorInfo& info : accelerator_infos()) {
    for (const Level level : all_levels) {
      const auto tracer = make_solid_tracer(info.name, solids, level);
      std::vector<Hit<double>> hits(rays.size());
      tracer->closest_hits(rays, hits);
      Tally& tally = trial.of(info.name, level);
      // Of itself, as lib/README.md promises of solids' t.
      const double share = level == Level::fast ? 0x1p-18 : level == Level::watertight ? 0x1p-46 : 0x1p-52;
      for (std::size_t i = 0; i < rays.size(); ++i) {
        const double t = boxes[of[i]].lo.x + 1;  // one rounding
        const double error = hits[i].is_hit() ? std::fabs(hits[i].t - t) / t : 0;
        const bool is_right = hits[i].is_hit() == truth(i) && (!truth(i) || hits[i].prim_id == of[i]);
        const bool is_near = error <= share && level != Level::exact;
        tally.add(!is_right    ? Verdict::wrong
                  : error == 0 ? Verdict::exact
                  : is_near    ? Verdict::within_bound
                               : Verdict::wrong,
                  error, [&] { return example(i, hits[i].is_hit() ? "hit at " + text_of_number(hits[i].t) : "none"); });
      }
    }
  }
  Tally& naive = trial.naive("clip planes rounded to the nearest float");
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const bool is_kept =
        rays[i].origin.y >= double(float(boxes[of[i]].lo.y)) && rays[i].origin.y <= double(float(boxes[of[i]].hi.y));
    naive.decide(is_kept || !truth(i), [&] { return example(i, "culled"); });
  }
}

// ---- build-same-centroid

/// How deep a tree becomes that puts below what has its center below the mean of all centers.
int depth_by_mean(std::vector<float> centers, int depth) {
  if (centers.size() <= 4 || depth == 64) return depth;
  double sum = 0;
  for (const float x : centers) sum += double(x);
  const double mean = sum / double(centers.size());
  std::vector<float> below, above;
  for (const float x : centers) (double(x) < mean ? below : above).push_back(x);
  return std::max(depth_by_mean(std::move(below), depth + 1), depth_by_mean(std::move(above), depth + 1));
}

/// Equal triangles, or such of different sizes around the same center.
TriangleMesh around_one_center(std::uint64_t count, bool is_equal) {
  laws::MeshMaker maker;
  for (std::uint64_t i = 0; i < count; ++i) {
    const float size = is_equal ? 1 : 1 + static_cast<float>(i);
    // The box's center is the origin for any size.
    maker.add({-size, -size, -size}, {size, -size, 0}, {0, size, size});
  }
  return maker.make();
}

void run_same_centroid(Trial& trial) {
  for (const bool is_equal : {true, false}) {
    const std::uint64_t count = is_equal ? trial.count(100'000) : trial.count(1000);
    const TracedMesh traced(around_one_center(count, is_equal));
    const Ray<float> ray{{0.125f, -0.25f, -3e5f}, {0, 0, 1}};
    const Ray<double> wide = to_double(ray);
    // All are met at t where the first is, or, of those of all sizes, the nearest is as near as the largest's plane.
    std::vector<TrueCrossing> truth = true_crossings(is_equal ? around_one_center(1, true) : traced.mesh(), wide);
    for (const auto& tracer : traced.tracers()) {
      const auto judge = [&]<class T>(const Ray<T>& one, Level level, T t) {
        Hit<T> hit;
        tracer->closest_hits(std::span(&one, 1), std::span(&hit, 1), level);
        const bool is_right = hit.is_hit() && hit.prim_id == truth[0].id;
        const double error = std::fabs(double(hit.t) / double(t) - 1);
        // The farthest vertex is less than twice as far as the hit.
        const double share = level == Level::fast ? 0x1p-18 : level == Level::watertight ? 0x1p-23 : 0x1p-34;
        const Verdict verdict = !is_right                                 ? Verdict::wrong
                                : error == 0                              ? Verdict::exact
                                : error <= share && level != Level::exact ? Verdict::within_bound
                                                                          : Verdict::wrong;
        trial.of(tracer->name(), level).add(verdict, error, [&] {
          return Example{std::to_string(count) + " triangles around one center, " + text_of_ray(wide),
                         "triangle " + std::to_string(truth[0].id) + " at " + text_of_number(truth[0].t),
                         "triangle " + std::to_string(hit.prim_id) + " at " + text_of_number(double(hit.t))};
        });
      };
      judge(ray, Level::fast, truth[0].t_float);
      judge(ray, Level::watertight, truth[0].t_float);
      judge(wide, Level::precise, truth[0].t);
      judge(wide, Level::exact, truth[0].t);
      const std::size_t all = tracer->all_hits(wide).size(), expected = is_equal ? count : truth.size();
      trial.of(tracer->name(), Level::exact).decide(all == expected, [&] {
        return Example{std::to_string(count) + " triangles around one center", std::to_string(expected) + " hits",
                       std::to_string(all) + " hits"};
      });
    }
    const int depth = depth_by_mean(std::vector<float>(count, 0), 0);
    trial.naive("recursion where center < mean").decide(depth < 64, [&] {
      return Example{std::to_string(count) + " centers that are equal", "an end", "64 levels, and no end"};
    });
  }
}

// ---- bsp-on-plane

/// Pieces of slanted planes, tiles of them and the same a float's step beside: each plane is a splitter that others are
/// on, or nearly.
void run_on_plane(Trial& trial) {
  Random random(104);
  laws::MeshMaker maker;
  std::vector<Ray<float>> rays;
  std::vector<std::pair<Triangle, Vec3f>> questions;
  for (std::uint64_t plane = 0; plane < trial.count(80); ++plane) {
    const Vec3d at = 8.0 * Vec3d(laws::random_point(random, 0, 1)), u(laws::random_point(random, -1, 1)),
                v(laws::random_point(random, -1, 1));
    Triangle first{};
    for (int k = 0; k < 6; ++k) {
      const Vec3d corner = at + 0.8 * k * u;
      Triangle tile{Vec3f(corner), Vec3f(corner + u), Vec3f(corner + v)};
      if (k % 3 == 1) tile.a.z = std::nextafter(tile.a.z, INFINITY);
      if (k % 3 == 2) tile.c.x = std::nextafter(tile.c.x, -INFINITY);
      if (k == 0) first = tile;
      maker.add(tile.a, tile.b, tile.c);
      for (const Vec3f& p : {tile.a, tile.b, tile.c}) questions.emplace_back(first, p);
      const Vec3d target = corner + 0.3 * u + 0.3 * v, from = target + Vec3d(laws::random_point(random, -4, 4));
      rays.push_back({Vec3f(from), Vec3f(target - from)});
      rays.push_back({tile.a, Vec3f(target - from)});  // begins on the plane
    }
  }
  const TracedMesh traced(maker.make());
  MeshQuestion(traced.mesh(), std::move(rays)).ask(trial, traced);
  Tally& naive = trial.naive("side by the sign of n.p - w in float");
  for (const auto& [splitter, p] : questions) {
    const Vec3f n = glm::cross(splitter.b - splitter.a, splitter.c - splitter.a);
    const float d = glm::dot(n, p) - glm::dot(n, splitter.b);
    const int found = d > 0 ? 1 : d < 0 ? -1 : 0, truth = ExactPlane(splitter).side_of(Vec3d(p));
    naive.decide(found == truth, [&, corner = Vec3d(p)] {
      return Example{"corner " + text_of_point(corner), "side " + std::to_string(truth),
                     "side " + std::to_string(found)};
    });
  }
}

// ---- Drawings

Sketch draw_clip_round() {
  Sketch sketch{
      "The upper face of a box, and the clip plane rounded to the float below it; the gap is drawn 10^8 fold.", {}};
  return sketch.rectangle({0, 0}, {3, 2})
      .line({-1, 1.6}, {4, 1.6}, Role::naive)
      .line({-2, 1.8}, {4, 1.8}, Role::ray)
      .dot({0, 1.8})
      .label({0.3, 2.3}, "hi, a double")
      .label({0.3, 1.3}, "float(hi): a ray between them is culled", Role::naive);
}
Sketch draw_same_centroid() {
  Sketch sketch{"Triangles around one center. No plane has some of the centers on its left and some on its right.", {}};
  for (const double s : {1.0, 1.5, 2.0, 2.5}) sketch.polygon({{-s, -s}, {s, -s}, {0, s}});
  return sketch.dot({0, 0}, Role::aid)
      .line({0, -3}, {0, 3}, Role::naive)
      .label({0.2, 2.7}, "all are right of it; so once more; so once more", Role::naive);
}
Sketch draw_on_plane() {
  Sketch sketch{
      "Tiles of one plane, seen from the side. Rounding puts corners a step above or below it, drawn 10^7 fold.", {}};
  return sketch.line({-4, 0}, {4, 0}, Role::aid)
      .line({-3.5, 0.1}, {-1.2, -0.1}, Role::shape)
      .line({-1, 0}, {1, 0}, Role::shape)
      .line({1.2, -0.1}, {3.5, 0.12}, Role::shape)
      .line({-1.5, 2}, {0.3, -1.5}, Role::ray)
      .dot({-0.47, 0})
      .label({-3.4, 0.4}, "before? behind? both? n.p - w says by chance", Role::naive);
}

}  // namespace

HardCase bih_clip_round() {
  return {
      .id = "bih-clip-round",
      .group = "accelerator",
      .inputs = "300 boxes of doubles; rays along x in their faces, a step beside, and between face and float",
      .expected = "a hit within the closed box, none beside it; t correctly rounded",
      .why =
          "A node keeps planes as floats. Rounded to nearest, half of them move into what they bound, and rays between "
          "plane and primitive are culled. They have to be rounded outward.",
      .oracle = Oracle::closed_form,
      .reference = "Waechter and Keller 2006",
      .run = run_clip_round,
      .draw = draw_clip_round};
}
HardCase build_same_centroid() {
  return {
      .id = "build-same-centroid",
      .group = "accelerator",
      .inputs = "100,000 equal triangles; 1000 triangles of all sizes around one center",
      .expected = "building ends, each triangle is found, and of equally near ones the lowest id",
      .why =
          "Where all centers are one, every plane leaves all primitives on one side. A recursion that waits for small "
          "lists never ends, and one that cuts lists in halves may need a deeper stack than traversal has.",
      .oracle = Oracle::rationals,
      .reference = "tinybvh, stack[64]",
      .run = run_same_centroid,
      .draw = draw_same_centroid};
}
HardCase bsp_on_plane() {
  return {
      .id = "bsp-on-plane",
      .group = "accelerator",
      .inputs = "80 slanted planes of 6 tiles each, every third as computed, the others a float's step off",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A polygon in the splitting plane has corners whose computed distance is a rounding error of any sign, its "
          "own included. It is then cut into slivers, or sent to one side and looked for on the other.",
      .oracle = Oracle::rationals,
      .reference = "Fuchs, Kedem and Naylor 1980",
      .run = run_on_plane,
      .draw = draw_on_plane};
}

}  // namespace sightline::hard
