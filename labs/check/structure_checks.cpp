#include "labs/check/structure_checks.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "labs/check/structure_scene.h"
#include "labs/kit/structure_questions.h"
#include "labs/kit/structure_service.h"
#include "sightline/accel/brute_force.h"

namespace sightline::labs {
namespace {

/// Bits, so that zeros are told apart.
template <class T>
bool is_same(const Hit<T>& a, const Hit<T>& b) {
  return a == b && std::signbit(a.t) == std::signbit(b.t);
}

template <class T>
std::string text_of(const Hit<T>& hit) {
  if (!hit.is_hit()) return "no hit";
  std::ostringstream out;
  out.precision(std::numeric_limits<T>::max_digits10);
  out << "triangle " << hit.prim_id << " at t = " << hit.t;
  return out.str();
}

std::string text_of(const Vec3f& v) {
  std::ostringstream out;
  out << '(' << v.x << ' ' << v.y << ' ' << v.z << ')';
  return out.str();
}

/// The nearest hit, in T, and whether any_hit agrees.
template <class T>
std::optional<Trouble> hit_trouble(Subject& subject, const std::vector<Triangle>& triangles,
                                   const std::vector<Ray<T>>& rays, bool divides_few = false) {
  build(subject, triangles, divides_few);
  const char* question = std::is_same_v<T, float> ? "trace" : "trace-double";
  const auto traced = subject.ask<TracedRays<T>>(question, rays);
  const auto truth = true_hits<T>(triangles, rays);
  if (traced.hits.size() != rays.size() || traced.is_hit.size() != rays.size()) {
    return Trouble{std::to_string(rays.size()) + " hits", std::to_string(traced.hits.size())};
  }
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!is_same(traced.hits[i], truth[i])) return Trouble{text_of(truth[i]), text_of(traced.hits[i])};
    if ((traced.is_hit[i] != 0) != truth[i].is_hit()) {
      return Trouble{std::string(truth[i].is_hit() ? "any_hit true" : "any_hit false") + ", as the nearest hit says",
                     truth[i].is_hit() ? "false" : "true"};
    }
  }
  return std::nullopt;
}

using SceneOf = std::function<SmallScene(const Case&)>;

Check small_check(std::string name, const std::string& section, std::string why, std::vector<std::string> hints,
                  const Recipe& recipe, SceneOf scene_of, int count) {
  Check check{std::move(name), section, std::move(why), std::move(hints), recipe, count, false, {}, {}, {}};
  check.ask = [scene_of](const Case& at, Subject& subject) {
    const SmallScene scene = scene_of(at);
    if (auto trouble = hit_trouble<float>(subject, scene.triangles, {scene.ray}, true)) return trouble;
    return hit_trouble<double>(subject, scene.triangles, {to_double(scene.ray)}, true);
  };
  check.describe = [scene_of](const Case& at) { return describe(scene_of(at)); };
  check.draw = [scene_of](const Case& at, Subject& subject) { return draw_walk(scene_of(at), subject); };
  return check;
}

SceneOf with(int extent, float scale) {
  return [=](const Case& at) { return small_scene(at, extent, scale); };
}

/// Tenths, which are not what they seem, and a ray at one of the corners: planes through corners are where all of it
/// meets.
SmallScene corner_scene(const Case& at) {
  SmallScene scene = small_scene(at, 4, 0.1f);
  if (scene.triangles.empty()) return scene;
  const auto choice = static_cast<std::size_t>(std::abs(at.head[3] + 8 * at.head[4] + 64 * at.head[5]));
  const Triangle& aim = scene.triangles[choice % scene.triangles.size()];
  const Vec3f corners[] = {aim.a, aim.b, aim.c};
  scene.ray.direction = corners[choice % 3] - scene.ray.origin;
  if (scene.ray.direction == Vec3f(0)) scene.ray.direction = {0, 0, 1};
  return scene;
}

/// A scene that is not drawn by chance.
Check fixed_check(std::string name, const std::string& section, std::string why, std::vector<std::string> hints,
                  std::string input, std::function<std::optional<Trouble>(Subject&)> ask) {
  Check check{std::move(name), section, std::move(why), std::move(hints), {}, 1, false, {}, {}, {}};
  check.ask = [ask = std::move(ask)](const Case&, Subject& subject) { return ask(subject); };
  check.describe = [input = std::move(input)](const Case&) { return input; };
  return check;
}

const Triangle unit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const Ray<float> through_unit{{0.25f, 0.25f, -1}, {0, 0, 1}};

std::optional<Trouble> few_trouble(Subject& subject) {
  const auto facts = build(subject, {});
  if (!facts.leaf_order.empty()) return Trouble{"an empty leaf_order", std::to_string(facts.leaf_order.size())};
  if (auto trouble = hit_trouble<float>(subject, {}, {through_unit})) return trouble;
  if (auto trouble = hit_trouble<float>(subject, {unit}, {through_unit})) return trouble;
  const Triangle point{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
  return hit_trouble<float>(subject, std::vector<Triangle>(20, point), {{{1, 1, 0}, {0, 0, 1}}});
}

/// Rays that hit nothing by definition (ray.h), in a scene that every other ray would have a long way through.
std::optional<Trouble> broken_trouble(Subject& subject) {
  build(subject, budget_triangles());
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  const std::vector<Ray<float>> rays{{{0, 0, nan}, {1, 0, 0}},       {{0, 0, 0}, {nan, 1, 0}},
                                     {{0, infinity, 0}, {1, 1, 0}},  {{0, 0, 0}, {0, 0, 0}},
                                     {{0, 0, 0}, {0, -infinity, 0}}, {{0, 0, 0}, {1, 2, 3}, 2, 1}};
  for (const Ray<float>& ray : rays) {
    const auto traced = subject.ask<TracedRays<float>>("trace", std::vector{ray});
    if (traced.stats.leaves == 0 && traced.stats.nodes <= 1) continue;
    std::ostringstream input;
    input << "ray from " << text_of(ray.origin) << " along " << text_of(ray.direction) << ", t from " << ray.t_min
          << " to " << ray.t_max;
    return Trouble{
        "no leaf opened, and at most one node, by the " + input.str(),
        std::to_string(traced.stats.leaves) + " leaves and " + std::to_string(traced.stats.nodes) + " nodes"};
  }
  return std::nullopt;
}

std::optional<Trouble> copies_trouble(Subject& subject) {
  const std::vector<Triangle> copies(2000, unit);
  const auto facts = build(subject, copies);
  if (facts.leaf_order.size() > 16 * copies.size()) {
    return Trouble{"at most 16 places in leaf_order for each of 2000 equal triangles, which nothing divides",
                   std::to_string(facts.leaf_order.size()) + " places"};
  }
  return hit_trouble<float>(subject, copies, {through_unit});
}

std::optional<Trouble> cells_trouble(Subject& subject) {
  const std::vector<Triangle> triangles = budget_triangles();
  const auto facts = build(subject, triangles);
  std::vector<bool> is_held(triangles.size(), false);
  for (const std::uint32_t id : facts.leaf_order) {
    if (id >= triangles.size()) return Trouble{"ids below " + std::to_string(triangles.size()), std::to_string(id)};
    is_held[id] = true;
  }
  const auto lost = std::ranges::find(is_held, false) - is_held.begin();
  if (lost < std::ssize(is_held))
    return Trouble{"every triangle in leaf_order", "triangle " + std::to_string(lost) + " is not there"};
  std::size_t leaves = 0, largest = 0;
  for (const Cell& cell : subject.ask<std::vector<Cell>>("cells")) {
    if (std::uint64_t(cell.range.first) + cell.range.count > facts.leaf_order.size()) {
      return Trouble{"leaves within leaf_order", "a leaf of positions " + std::to_string(cell.range.first) + " and on"};
    }
    leaves += cell.is_leaf && cell.range.count > 0;
    largest = std::max<std::size_t>(largest, cell.range.count);
  }
  if (leaves < 100) return Trouble{"more than 100 leaves", std::to_string(leaves)};
  if (largest > 200) return Trouble{"no leaf of more than 200", "one of " + std::to_string(largest)};
  return std::nullopt;
}

std::optional<Trouble> repeat_trouble(Subject& subject) {
  const std::vector<Triangle> triangles = budget_triangles();
  const auto first = build(subject, triangles);
  const auto second = build(subject, triangles);
  if (first.leaf_order != second.leaf_order) return Trouble{"the same leaf_order when built again", "another one"};
  return std::nullopt;
}

Check budget_check(const StructureTopics& topics) {
  Check check = fixed_check(
      "budget", topics.budget, "A structure that gives the right hits slowly has divided nothing.",
      {"Count for yourself: sightline lab view shows the walk of one ray. Does it enter leaves it need not?",
       "Does what is put aside and lies beyond the far limit get dropped unopened?",
       "Is the division the cheapest one by the surface area heuristic, or just some division?"},
      std::to_string(budget_triangles().size()) + " triangles in crowds and between them, 2000 rays",
      [topics](Subject& subject) -> std::optional<Trouble> {
        build(subject, budget_triangles());
        const auto rays = budget_rays();
        const TraversalStats stats = subject.ask<TracedRays<float>>("trace", rays).stats;
        const auto each = [&](std::uint64_t count) {
          return std::round(10 * static_cast<double>(count) / static_cast<double>(rays.size())) / 10;
        };
        const double nodes = each(stats.nodes + stats.leaves), candidates = each(stats.candidates);
        if (nodes <= topics.most_nodes && candidates <= topics.most_candidates) return std::nullopt;
        std::ostringstream allowed, used;
        allowed << "at most " << topics.most_nodes << " nodes and " << topics.most_candidates << " triangles a ray";
        used << nodes << " nodes and " << candidates << " triangles a ray";
        return Trouble{allowed.str(), used.str()};
      });
  check.is_budget = true;
  return check;
}

}  // namespace

StructureFacts build(Subject& subject, std::span<const Triangle> triangles, bool divides_few) {
  std::vector<WantedOption> wanted;
  if (divides_few) wanted = {{"max_leaf_size", "1"}, {"traversal_cost", "0.01"}};
  return subject.ask<StructureFacts>("build", std::vector<Triangle>(triangles.begin(), triangles.end()), wanted);
}

template <class T>
std::vector<Hit<T>> true_hits(std::span<const Triangle> triangles, std::span<const Ray<T>> rays) {
  const TriangleMesh mesh = mesh_of({triangles.begin(), triangles.end()});
  const BruteForce all = BruteForce::build(PrimitivesOf(mesh));
  const IndexedLeaves leaves(mesh, all.leaf_order());
  std::vector<Hit<T>> hits;
  NoProbe silent;
  for (const Ray<T>& ray : rays) hits.push_back(closest_hit(all, leaves, ray, silent));
  return hits;
}
template std::vector<Hit<float>> true_hits(std::span<const Triangle>, std::span<const Ray<float>>);
template std::vector<Hit<double>> true_hits(std::span<const Triangle>, std::span<const Ray<double>>);

SmallScene small_scene(const Case& at, int extent, float scale) {
  const auto vector = [&](const std::vector<int>& numbers, std::size_t first) {
    return scale * Vec3f(numbers[first], numbers[first + 1], numbers[first + 2]);
  };
  SmallScene scene{{}, {2.0f * vector(at.head, 0), {}}};
  scene.ray.direction = vector(at.head, 3) - scene.ray.origin;
  if (scene.ray.direction == Vec3f(0)) scene.ray.direction = {0, 0, scale};
  for (auto item : at.items) {
    for (std::size_t i = 3; i < item.size(); ++i) item[i] %= extent;
    const Vec3f a = vector(item, 0);
    scene.triangles.push_back({a, a + vector(item, 3), a + vector(item, 6)});
  }
  return scene;
}

std::string describe(const SmallScene& scene) {
  std::string text = "ray from " + text_of(scene.ray.origin) + " along " + text_of(scene.ray.direction);
  for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
    const Triangle& t = scene.triangles[i];
    if (i == 8) return text + "\nand " + std::to_string(scene.triangles.size() - i) + " more";
    text += "\ntriangle " + std::to_string(i) + ": " + text_of(t.a) + " " + text_of(t.b) + " " + text_of(t.c);
  }
  return text;
}

std::vector<Check> structure_checks(const StructureTopics& topics) {
  const Recipe lattice{6, 9, 60, 4}, fine{6, 9, 100, 4096};
  std::vector<Check> checks;
  checks.push_back(fixed_check(
      "few", topics.construction, "Scenes begin empty: a structure of nothing, of one, and of points has to stand.",
      {"What does build make of no primitives at all, and what does traverse then do?",
       "Triangles may be points. Where does your division end when all of them are at the same place?"},
      "no triangle; one; twenty that are a point", few_trouble));
  checks.push_back(small_check(
      "lattice", topics.walk,
      "Walls meet floors, rays run along edges: on a grid of whole numbers planes coincide with triangles, and "
      "triangles "
      "with each other. Random triangles never show that.",
      {"Draw the case: the picture numbers the cells in the order in which you entered them.",
       "A triangle that lies exactly in a plane that divides, or a ray that runs within it, belongs to a side. To "
       "which?",
       "Of equally distant triangles the one of the lower id counts: so a cell that begins exactly at the nearest hit "
       "may not be skipped."},
      lattice, with(4, 1), 1000));
  checks.push_back(small_check(
      "corners", topics.walk,
      "Corners that triangles share are hit by one ray in a million, and a picture has millions: each one missed is a "
      "bright dot.",
      {"Planes pass through corners, and where a ray meets both is rounded. On which side of the plane is the hit "
       "then?",
       "PaddedRay enters a little earlier and leaves a little later than the ray: enough for all that is rounded."},
      lattice, corner_scene, 1000));
  checks.push_back(
      small_check("soup", topics.walk, "Triangles of any size and place, as scenes have them.",
                  {"Which cell holds the triangle that is missed, and at which node did the ray turn away from it?",
                   "Entering is compared with leaving. Are both right where the direction is negative?"},
                  fine, with(3000, 0x1p-10f), 400));
  checks.push_back(fixed_check(
      "broken-rays", topics.walk,
      "One NaN in a picture's first bounce becomes a ray that visits everything, and then a picture that takes hours.",
      {"PaddedRay makes the range of a broken ray empty: padded.t_min lies above padded.t_max.",
       "Is it ray.t_max or padded.t_max that you clip with?"},
      "rays with NaN, with infinity, without a direction, with an empty range", broken_trouble));
  checks.push_back(fixed_check(
      "copies", topics.construction, "Models hold the same triangle twice, or two thousand times.",
      {"What ends your division where no plane and no grouping helps?"}, "2000 equal triangles", copies_trouble));
  checks.push_back(fixed_check(
      "divides", topics.construction, "A list of all triangles gives the right hits too: it is no structure.",
      {"Print the number of leaves, and the size of the largest.", "Is a leaf made too early, or no division found?"},
      std::to_string(budget_triangles().size()) + " triangles in crowds and between them", cells_trouble));
  checks.push_back(fixed_check(
      "repeatable", topics.construction, "What cannot be built twice alike cannot be debugged, nor measured.",
      {"Is there a random number, or an address, that decides?"}, "the same triangles, built twice", repeat_trouble));
  checks.push_back(budget_check(topics));
  return checks;
}

}  // namespace sightline::labs
