/// Trees that follow primitives which move: their hits stay those of brute force.

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "sightline/accel/registry.h"
#include "sightline/query/primitives_of.h"
#include "tests/accel/law_checks.h"
#include "tests/accel/law_scenes.h"

namespace sightline::laws {
namespace {

/// Others in the same places: the first is the last.
class Reversed final : public Primitives {
 public:
  explicit Reversed(const Primitives& primitives) : primitives_(primitives) {}

  std::uint32_t size() const override { return primitives_.size(); }
  Aabb bounds(std::uint32_t id) const override { return primitives_.bounds(other(id)); }
  Aabb clip(std::uint32_t id, const Aabb& box) const override { return primitives_.clip(other(id), box); }
  Hull hull(std::uint32_t id) const override { return primitives_.hull(other(id)); }
  CandidatePlanes planes(std::uint32_t id) const override { return primitives_.planes(other(id)); }

 private:
  std::uint32_t other(std::uint32_t id) const { return size() - 1 - id; }

  const Primitives& primitives_;
};

/// Built where each primitive is far from where it will be.
template <class Structure, auto change>
class Refitted : public Structure {
 public:
  using Options = typename Structure::Options;

  static Refitted build(const Primitives& primitives, Options options) {
    change(options);
    Structure built = Structure::build(Reversed(primitives), options);
    EXPECT_TRUE(built.can_refit());
    return Refitted(Structure::refit(std::move(built), primitives));
  }

 private:
  explicit Refitted(Structure&& structure) : Structure(std::move(structure)) {}
};

constexpr auto keep = [](auto&) {};
constexpr auto split = [](auto& options) { options.splits = 100; };
constexpr auto compress = [](WideTreeOptions& options) { options.compressed = true; };
constexpr auto drop_slabs = [](BoundingIntervalHierarchyOptions& options) { options.slabs = false; };

template <class A>
class Refits : public testing::Test {};
using Trees =
    testing::Types<Refitted<BruteForce, keep>, Refitted<BoxTree, keep>, Refitted<BoxTree, split>,
                   Refitted<WideTree, keep>, Refitted<WideTree, split>, Refitted<WideTree, compress>,
                   Refitted<BoundingIntervalHierarchy, keep>, Refitted<BoundingIntervalHierarchy, drop_slabs>>;
TYPED_TEST_SUITE(Refits, Trees);

TYPED_TEST(Refits, HitsAreThoseOfBruteForce) {
  expect_brute_force_hits_about<TypeParam>(soup(500, 0.05f, 1), 500, 2);
  expect_brute_force_hits<TypeParam>(lattice(300, 6, 5), lattice_rays<float>(6, 2000, 6));
  expect_brute_force_hits_about<TypeParam>(transformed(soup(200, 0.1f, 3), 10, {1e6f, -2e6f, 3e5f}), 300, 4);
  expect_brute_force_hits<TypeParam>(TriangleMesh(), lattice_rays<float>(2, 50, 7));
  expect_brute_force_hits<TypeParam>(copies(1), lattice_rays<float>(2, 50, 8));
}

/// Primitives that stay where they are give the tree that they gave.
template <class Structure>
void expect_same_tree() {
  const TriangleMesh mesh = soup(2000, 0.05f, 9);
  const PrimitivesOf primitives(mesh);
  const Structure built = Structure::build(primitives),
                  refitted = Structure::refit(Structure::build(primitives), primitives);
  EXPECT_EQ(dump(built), dump(refitted)) << Structure::name;
}

TEST(Refit, OfWhatHasNotMovedChangesNothing) {
  expect_same_tree<BruteForce>();
  expect_same_tree<BoxTree>();
  expect_same_tree<WideTree>();
}

TEST(Refit, OfALazyTreeIsRefused) {
  const TriangleMesh mesh = soup(100, 0.05f, 9);
  BoundingIntervalHierarchyOptions options;
  EXPECT_TRUE(BoundingIntervalHierarchy::build(PrimitivesOf(mesh), options).can_refit());
  options.lazy = true;
  EXPECT_FALSE(BoundingIntervalHierarchy::build(PrimitivesOf(mesh), options).can_refit());
}

}  // namespace
}  // namespace sightline::laws
