#include <cmath>
#include <numeric>

#include "bench/claims/course.h"
#include "bench/claims/order_tree.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "bench/verify.h"
#include "sightline/math/random.h"
#include "sightline/query/queries.h"

namespace sightline::bench {
namespace {

/// What is compared: how objects are grouped, and how the groups are walked.
struct Way {
  const char* name;
  enum Grouping { list, shuffled, as_listed, sorted } grouping;
  ChildOrder children;
};
constexpr Way ways[] = {{"list", Way::list, ChildOrder::as_they_come},
                        {"grouped at random", Way::shuffled, ChildOrder::as_they_come},
                        {"grouped at random, nearer child first", Way::shuffled, ChildOrder::nearer_first},
                        {"grouped as the mesh lists them", Way::as_listed, ChildOrder::as_they_come},
                        {"sorted in space, children as they come", Way::sorted, ChildOrder::as_they_come},
                        {"sorted in space, nearer child first", Way::sorted, ChildOrder::nearer_first}};
constexpr std::size_t way_count = std::size(ways), random_way = 1, sorted_way = 4, ordered_way = 5;

std::vector<std::uint32_t> shuffled_ids(std::uint32_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> ids(count);
  std::iota(ids.begin(), ids.end(), 0u);
  Random random(seed);
  for (std::uint32_t i = count; i > 1; --i) std::swap(ids[i - 1], ids[random.below(i)]);
  return ids;
}

/// A tree walked in one way, as queries see it.
struct Walked {
  const OrderTree& tree;
  const Way& way;

  template <class T, class Visit>
  void traverse(const Ray<T>& ray, Visit&& visit, VolumeTests& tests) const {
    if (way.grouping == Way::list) return tree.traverse_list(ray, visit, tests);
    tree.traverse(ray, way.children, visit, tests);
  }
};

VolumeTests tests_of(const Way& way, const MeshPtr& mesh, std::span<const Ray<float>> rays,
                     std::span<const Hit<float>> expected, std::uint64_t seed) {
  std::vector<std::uint32_t> ids = shuffled_ids(mesh->size(), seed);
  if (way.grouping == Way::as_listed) std::iota(ids.begin(), ids.end(), 0u);
  const OrderTree tree(*mesh, std::move(ids), way.grouping == Way::sorted);
  const IndexedLeaves<TriangleMesh> leaves(*mesh, tree.leaf_order());
  VolumeTests tests;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Hit<float> hit = closest_hit(Walked{tree, way}, leaves, rays[i], tests);
    if (is_same(hit, expected[i])) continue;
    throw WrongHits(std::string(way.name) + ", ray " + std::to_string(i) + ": expected " + hit_text(expected[i]) +
                    ", found " + hit_text(hit));
  }
  return tests;
}

void measure_family(const Effort& effort, const std::string& family, Finding& finding,
                    std::vector<Condition>& conditions) {
  std::vector<double> x, volumes[way_count], objects[way_count];
  double own_share[way_count] = {};
  for (const std::size_t size : growing_sizes(effort, 320'000, 32'000)) {
    effort.say(family + " of " + std::to_string(size));
    const MeshPtr mesh = mesh_of(family, size);
    const auto rays = mixed_rays(mesh, effort.count(400, 200), effort.seed);
    std::vector<Hit<float>> expected(rays.size());
    traced("box-tree", mesh)->closest_hits(std::span<const Ray<float>>(rays), std::span(expected));
    const double per_ray = 1 / static_cast<double>(rays.size());
    x.push_back(mesh->size());
    for (std::size_t w = 0; w < way_count; ++w) {
      const VolumeTests tests = tests_of(ways[w], mesh, rays, expected, effort.seed);
      volumes[w].push_back(per_ray * static_cast<double>(tests.volumes));
      objects[w].push_back(per_ray * static_cast<double>(tests.objects));
      own_share[w] = 100 * per_ray * static_cast<double>(tests.own) / x.back();
    }
  }
  for (std::size_t w = 0; w < way_count; ++w) {
    const Growth growth =
        growth_of("volumes a ray, " + family + ", " + ways[w].name, "objects", "", x, volumes[w], family);
    const Figure exponent{"exponent of " + growth.name, exponent_of(growth), ""};
    const Figure own = exact_figure(
        family + ", " + ways[w].name + ": objects tested by their own volume, largest scene", own_share[w], "%");
    finding.growths.push_back(growth);
    if (w == random_way || w == ordered_way) {
      finding.figures.push_back(
          exact_figure(family + ", " + ways[w].name + ": objects tested a ray, largest scene", objects[w].back()));
    }
    finding.figures.push_back(exponent);
    finding.figures.push_back(own);
    if (w == random_way) {
      conditions.push_back({Condition::Kind::needed, exponent, Side::above, 0.9});
      conditions.push_back({Condition::Kind::wanted, own, Side::above, 90});
    }
    if (w == sorted_way || w == ordered_way) {
      conditions.push_back({Condition::Kind::needed, exponent, Side::below, 0.9});
    }
  }
}

Finding measure_unordered_hierarchies(const Effort& effort) {
  Finding finding;
  std::vector<Condition> conditions;
  on_one_thread([&] {
    for (const char* family : {"soup", "terrain"}) measure_family(effort, family, finding, conditions);
  });
  conclude(finding, conditions,
           "Tests grow in proportion to the objects, but boxes of few objects are missed by many rays, so that most "
           "objects are not tested one by one");
  return finding;
}

}  // namespace

const Claim unordered_hierarchies_claim{
    "unordered_hierarchies", "Hierarchies without spatial order still hit-test every object.",
    "One binary hierarchy of boxes, an object a leaf, over random triangles and a landscape of 1000 to 320,000 (quick: "
    "32,000): objects grouped at random, as the mesh lists them, or sorted in space, children walked as they come or "
    "nearer first; beside a list without a hierarchy. Boxes and objects tested are counted; all hits are the same.",
    "Holds if the tests of a hierarchy grouped at random grow with an exponent above 0.9 and those of one sorted in "
    "space do not, and if in the former, in the largest scene, more than 90 % are tested each by its own volume; holds "
    "with a limit if fewer are.",
    measure_unordered_hierarchies};

}  // namespace sightline::bench
