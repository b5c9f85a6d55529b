#include <cmath>

#include "bench/claims/course.h"
#include "bench/claims/point_tree.h"
#include "bench/claims/rules.h"
#include "bench/claims/tools.h"
#include "sightline/math/random.h"

namespace sightline::bench {
namespace {

/// What one object takes of a quantity at three sizes, whose logarithms are about equally far apart.
struct Thirds {
  double size[3], taken[3];

  /// What it grows by from the second to the third, over what it grows by from the first to the second, each over the
  /// logarithm of the size: 1 of n log n, whatever is beside it in proportion to n, and more of whatever grows faster.
  double steepening() const {
    const auto slope = [&](int k) {
      return (taken[k + 1] / size[k + 1] - taken[k] / size[k]) / std::log(size[k + 1] / size[k]);
    };
    return slope(1) / slope(0);
  }
};

std::size_t third_of(std::size_t sizes, int k) { return static_cast<std::size_t>(k) * (sizes - 1) / 2; }

Figure steepening_of(const Growth& growth) {
  Thirds thirds{};
  for (int k = 0; k < 3; ++k) {
    const std::size_t i = third_of(growth.x.size(), k);
    thirds.size[k] = growth.x[i], thirds.taken[k] = growth.y[i];
  }
  return exact_figure("steepening of " + growth.name, thirds.steepening(), "x");
}

/// By rounds, of times of the sizes x.
Figure steepening_of(const Growth& growth, std::span<const std::vector<double>> rounds) {
  std::vector<double> all;
  for (std::size_t round = 0; round < rounds[0].size(); ++round) {
    Thirds thirds{};
    for (int k = 0; k < 3; ++k) {
      const std::size_t i = third_of(growth.x.size(), k);
      thirds.size[k] = growth.x[i], thirds.taken[k] = rounds[i][round];
    }
    all.push_back(thirds.steepening());
  }
  return {"steepening of " + growth.name, known(estimate_of_present(all)), "x"};
}

/// References times the number of cells that hold each, from the root to its leaf: what passes through a builder's
/// hands.
double references_handled(const Tracer& tracer) {
  double sum = 0;
  tracer.for_each_cell([&](const Cell& cell) {
    if (cell.is_leaf) sum += static_cast<double>(cell.range.count) * (cell.depth + 1);
  });
  return sum;
}

TracerPtr build(const std::string& quality, const MeshPtr& mesh) {
  return make_tracer("kd-tree", mesh, {{{"quality", quality}}, false, 1});
}

struct Asked {
  Condition::Kind kind;
  Growth growth;
  Figure steepening;
};

void measure_family(const Effort& effort, const std::string& family, const std::vector<std::size_t>& sizes,
                    std::vector<Asked>& asked) {
  const std::vector<std::string> qualities{"fast", "balanced"};
  std::vector<double> x;
  std::vector<std::vector<double>> works(qualities.size()), ms(qualities.size());
  std::vector<std::vector<std::vector<double>>> rounds(qualities.size());
  for (const std::size_t size : sizes) {
    const MeshPtr mesh = mesh_of(family, size);
    x.push_back(mesh->size());
    std::vector<Line> lines;
    for (std::size_t q = 0; q < qualities.size(); ++q) {
      works[q].push_back(references_handled(*build(qualities[q], mesh)));
      lines.push_back(
          {[mesh, quality = qualities[q]] { return static_cast<double>(build(quality, mesh)->structure_bytes()); }});
    }
    const Times times = time_lines(effort, family + " of " + std::to_string(size), lines, effort.is_quick ? 0.4 : 8);
    for (std::size_t q = 0; q < qualities.size(); ++q) {
      ms[q].push_back(times.nanoseconds(q).median * 1e-6);
      rounds[q].push_back(times.rounds(q));
    }
  }
  for (std::size_t q = 0; q < qualities.size(); ++q) {
    const std::string name = ", " + family + ", " + qualities[q];
    const Growth work = growth_of("references handled" + name, "triangles", "", x, works[q], "building: work");
    const Growth time = growth_of("time" + name, "triangles", "ms", x, ms[q], "building: time");
    asked.push_back({Condition::Kind::needed, work, steepening_of(work)});
    asked.push_back({Condition::Kind::wanted, time, steepening_of(time, rounds[q])});
  }
}

/// Comparisons of inserting points one after the other.
Growth insertion(const std::string& name, const std::vector<std::size_t>& sizes, std::uint64_t seed, bool is_sorted) {
  std::vector<double> x, compared;
  for (const std::size_t size : sizes) {
    Random random(seed);
    PointTree<3> tree;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const float along = static_cast<float>(i);
      sum += tree.insert(is_sorted ? std::array{along, along, along}
                                   : std::array{random.uniform(), random.uniform(), random.uniform()});
    }
    x.push_back(static_cast<double>(size));
    compared.push_back(static_cast<double>(sum));
  }
  return growth_of(name, "points", "", x, compared, "inserting points: comparisons");
}

/// Of n (log n)^power over these sizes.
Growth of_logarithm(const std::string& name, const std::vector<std::size_t>& sizes, int power) {
  std::vector<double> x, y;
  for (const std::size_t size : sizes) {
    x.push_back(static_cast<double>(size));
    y.push_back(x.back() * std::pow(std::log2(x.back()), power));
  }
  return growth_of(name, "", "", x, y);
}

Finding measure_kd_build(const Effort& effort) {
  const auto sizes = growing_sizes(effort, 1'000'000, 100'000), few = growing_sizes(effort, 32'000, 10'000);
  std::vector<Asked> asked;
  on_one_thread([&] {
    for (const char* family : {"soup", "terrain"}) measure_family(effort, family, sizes, asked);
  });
  effort.say("inserting points");
  const Growth random = insertion("comparisons, points inserted at random", sizes, effort.seed, false);
  const Growth sorted = insertion("comparisons, points inserted in order", few, effort.seed, true);
  asked.push_back({Condition::Kind::needed, random, steepening_of(random)});
  asked.push_back({Condition::Kind::wanted, sorted, steepening_of(sorted)});

  Finding finding;
  const Growth one = of_logarithm("n log n", sizes, 1), two = of_logarithm("n (log n)^2", sizes, 2);
  const double limit = 0.5 * (1 + steepening_of(two).value.median);
  finding.figures.push_back(steepening_of(two));
  finding.figures.push_back(exact_figure("limit: halfway to that from 1, of n log n", limit, "x"));
  finding.figures.push_back(exact_figure("exponent that n log n fits as over these sizes", one.fit->exponent));
  finding.figures.push_back(exact_figure("exponent that n (log n)^2 fits as", two.fit->exponent));
  std::vector<Condition> conditions;
  for (const auto& [kind, growth, steepening] : asked) {
    finding.growths.push_back(growth);
    finding.figures.push_back(steepening);
    finding.figures.push_back({"exponent of " + growth.name, exponent_of(growth), ""});
    conditions.push_back({kind, steepening, Side::below, limit});
  }
  conclude(finding, conditions,
           "The counted work of building, and of inserting in a random order, is n log n; what else is measured grows "
           "faster");
  return finding;
}

}  // namespace

const Claim kd_build_claim{
    "kd_build", "Building a kd-tree, or inserting into one, is O(n log n).",
    "Kd-trees of the qualities fast (planes along one axis) and balanced (all planes swept) over random triangles and "
    "a landscape of 1000 to 1,000,000 (quick: 100,000): one thread's processor time, and the references that pass "
    "through the builder's hands. Beside them a textbook's kd-tree of points, filled one by one, at random and in "
    "order.",
    "What one triangle takes grows by as much from the middle size to the largest as from the smallest to the middle "
    "one (sizes evenly in logarithms) if the whole is n log n, whatever is beside that in proportion to n: steepening "
    "1. The limit is halfway to the steepening of n (log n)^2. Holds if all stay below; holds with a limit if the "
    "counted work of building and of insertion at random does, but a time or insertion in order does not. A first "
    "rule, on exponents alone, resolved nothing: terms in proportion to n bend them at these sizes.",
    measure_kd_build};

}  // namespace sightline::bench
