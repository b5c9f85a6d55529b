/// Kd-trees and bounding interval hierarchies: where planes and triangles, or cells and hits, do not agree.

#include "tests/hard_cases/naive_trees.h"

namespace sightline::hard {
namespace {

/// Triangles and rays of whole and half numbers, so that planes of all kinds coincide.
void ask_on_lattice(Trial& trial, KdFault fault, std::string_view name, bool (*takes)(const Ray<float>&)) {
  const TracedMesh traced(laws::lattice(300, 6, 81));
  std::vector<Ray<float>> rays;
  const std::uint64_t count = trial.count(2500);
  for (std::uint64_t seed = 82; rays.size() < count; ++seed) {
    for (const Ray<float>& ray : laws::lattice_rays<float>(6, 1000, seed)) {
      if (rays.size() < count && takes(ray)) rays.push_back(ray);
    }
  }
  const MeshQuestion question(traced.mesh(), std::move(rays));
  question.ask(trial, traced);
  ask_structure(trial.naive(name), question, NaiveKdTree(traced.mesh(), fault));
}

void run_planar(Trial& trial) {
  ask_on_lattice(trial, KdFault::planar, "kd-tree: below where lo < s, above where hi > s",
                 [](const Ray<float>&) { return true; });
}

bool has_zero(const Vec3f& d) { return d.x == 0 || d.y == 0 || d.z == 0; }
bool is_whole(const Vec3f& p) { return glm::floor(p) == p; }

void run_zero_direction(Trial& trial) {
  ask_on_lattice(trial, KdFault::zero_direction, "kd-tree: far child where t = (s - o) / d is in no range",
                 [](const Ray<float>& ray) { return has_zero(ray.direction) && is_whole(ray.origin); });
}
void run_split_at_origin(Trial& trial) {
  ask_on_lattice(trial, KdFault::split_at_origin, "kd-tree: the child below where o < s, and t <= 0 means near only",
                 [](const Ray<float>& ray) { return !has_zero(ray.direction) && is_whole(ray.origin); });
}

/// Triangles as large as the scene, which are in many cells and bounds that overlap.
template <class Structure, class... Args>
void ask_in_soup(Trial& trial, std::string_view name, Args... args) {
  const TracedMesh traced(laws::soup(150, 1, 83));
  const auto count = static_cast<int>(trial.count(2500));
  const MeshQuestion question(traced.mesh(), laws::rays_about<float>(traced.mesh().bounds(), count, 84));
  question.ask(trial, traced);
  ask_structure(trial.naive(name), question, Structure(traced.mesh(), args...));
}

void run_outside_cell(Trial& trial) {
  ask_in_soup<NaiveKdTree>(trial, "kd-tree: the first leaf with a hit ends the walk", KdFault::outside_cell);
}
void run_bih_overlap(Trial& trial) { ask_in_soup<NaiveBih>(trial, "bih: a hit in the near child ends the walk"); }

// ---- Drawings

Sketch two_cells(std::string caption) {
  Sketch sketch{std::move(caption), {}};
  return sketch.rectangle({-3, -2}, {0, 2}, Role::aid)
      .rectangle({0, -2}, {3, 2}, Role::aid)
      .label({-2.9, 1.6}, "below")
      .label({2.2, 1.6}, "above");
}
Sketch draw_planar() {
  return two_cells("A triangle, seen from its side, in the very plane that splits the cell.")
      .line({0, -1}, {0, 1}, Role::shape)
      .line({-2.5, -0.6}, {2.5, 0.6}, Role::ray)
      .dot({0, 0})
      .label({0.2, -1.4}, "not below s, not above s: in neither child", Role::naive);
}
Sketch draw_outside_cell() {
  return two_cells("A long triangle is in both cells. The ray meets it in the second, behind another one.")
      .line({-2.5, 0.2}, {2.8, -1.6}, Role::shape)
      .line({0.5, -0.2}, {1.2, -1.8}, Role::shape)
      .line({-2.5, -1.8}, {2.9, -1.1}, Role::ray)
      .dot({0.87, -1.36})
      .dot({1.85, -1.25}, Role::naive)
      .label({0.4, -0.1}, "true: deferred to its cell")
      .label({1.7, -1.0}, "tested in the first cell, taken at once", Role::naive);
}
Sketch draw_zero_direction() {
  return two_cells("A ray in the split plane: o = s and d = 0.")
      .line({0, -2}, {0, 2}, Role::ray)
      .line({-1.5, 0.8}, {0.6, 0.9}, Role::shape)
      .line({-0.5, -0.6}, {-2, -0.2}, Role::shape)
      .dot({0, 0.87})
      .label({0.3, 0.2}, "t = 0 / 0: NaN is in no range, one child is never seen", Role::naive);
}
Sketch draw_split_at_origin() {
  return two_cells("A ray that begins in the split plane and goes to the left.")
      .dot({0, 0}, Role::aid)
      .line({0, 0}, {-2.8, 0.8}, Role::ray)
      .line({-1.5, -0.5}, {-1.2, 1.2}, Role::shape)
      .dot({-1.34, 0.38})
      .label({0.2, -0.6}, "o < s is false, so `above` is near; t = 0 says: near only", Role::naive);
}
Sketch draw_overlap() {
  Sketch sketch{"Two children of a hierarchy whose bounds overlap, each with a triangle.", {}};
  return sketch.rectangle({-3, -1.5}, {1, 1.5}, Role::aid)
      .rectangle({-1, -1.3}, {3, 1.7}, Role::aid)
      .line({0.4, -1.2}, {0.9, 1.2}, Role::shape)
      .line({-0.6, -1}, {-0.8, 1.4}, Role::shape)
      .line({-4, 0}, {3, 0.3}, Role::ray)
      .dot({-0.7, 0.14})
      .dot({0.68, 0.2}, Role::naive)
      .label({-0.6, -1.8}, "true: in the child that comes second")
      .label({1.1, 0.6}, "hit in the first child: done, it says", Role::naive);
}

}  // namespace

HardCase kd_planar() {
  return {
      .id = "kd-planar",
      .group = "accelerator",
      .inputs = "300 triangles and 2500 rays of whole and half numbers: many triangles are in split planes",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A triangle in the split plane has lo = hi = s. Who sorts by lo < s and hi > s puts it nowhere. Where the "
          "comparisons are closed it is in both children, where one of them is, the ray must look there.",
      .oracle = Oracle::rationals,
      .reference = "Wald and Havran 2006",
      .run = run_planar,
      .draw = draw_planar};
}
HardCase kd_outside_cell() {
  return {
      .id = "kd-outside-cell",
      .group = "accelerator",
      .inputs = "150 triangles as large as the scene, in many cells each; 2500 rays",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A leaf's triangle may be hit outside of the leaf's cell, where a cell that comes later can hold something "
          "nearer. A hit counts at once only where it is before the cell's end.",
      .oracle = Oracle::rationals,
      .run = run_outside_cell,
      .draw = draw_outside_cell};
}
HardCase kd_zero_direction() {
  return {
      .id = "kd-zero-dir",
      .group = "accelerator",
      .inputs = "300 triangles of whole numbers, 2500 rays from whole points with zeros, +0 and -0, in their direction",
      .expected = "the nearest hit, as without any structure",
      .why =
          "A ray in the split plane has t = 0 / 0. NaN fails every comparison, so the branch that is left over is "
          "taken, whichever that is. Such a ray touches both children.",
      .oracle = Oracle::rationals,
      .run = run_zero_direction,
      .draw = draw_zero_direction};
}
HardCase kd_split_at_origin() {
  return {
      .id = "kd-tsplit-zero",
      .group = "accelerator",
      .inputs = "300 triangles of whole numbers, 2500 rays that begin at whole points and go slanting",
      .expected = "the nearest hit, as without any structure",
      .why =
          "The origin is in the split plane, so it does not tell which child is near; the direction does. Taken for "
          "above, and t = 0 for behind, a ray to the left never sees the left.",
      .oracle = Oracle::rationals,
      .reference = "pbrt-v3, kdtreeaccel.cpp",
      .run = run_split_at_origin,
      .draw = draw_split_at_origin};
}
HardCase bih_overlap() {
  return {.id = "bih-overlap",
          .group = "accelerator",
          .inputs = "150 triangles as large as the scene, so that bounds overlap everywhere; 2500 rays",
          .expected = "the nearest hit, as without any structure",
          .why =
              "Children of a hierarchy overlap. A hit in the child that the ray enters first may lie behind one in the "
              "other child: only its own entry, beyond the hit, excludes that.",
          .oracle = Oracle::rationals,
          .reference = "Waechter and Keller 2006",
          .run = run_bih_overlap,
          .draw = draw_overlap};
}

}  // namespace sightline::hard
