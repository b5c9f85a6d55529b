/// What the claims of matrices, solids and noise are measured with.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "bench/claims/polygons.h"
#include "bench/claims/spectrum.h"

namespace sightline::bench {
namespace {

OneSolid one(const SolidTree& tree) { return OneSolid({std::make_shared<const Solid>(tree)}); }

/// Times that each edge is a triangle's, by its corners.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges_of(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const TriangleMesh::Corners& corners : mesh.triangles()) {
    for (int i = 0; i < 3; ++i) ++edges[std::minmax(corners[i], corners[(i + 1) % 3])];
  }
  return edges;
}

TEST(Polygons, OfABallAreClosedAndLieOnIt) {
  const auto mesh = polygons_of(one(solid::Sphere{Vec3d(1, 2, 3), 2}), 16);
  for (const Vec3f& p : mesh->positions()) EXPECT_NEAR(glm::length(Vec3d(p) - Vec3d(1, 2, 3)), 2, 1e-6);
  const auto edges = edges_of(*mesh);
  for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2);
  const auto vertices = static_cast<long>(mesh->positions().size()), faces = static_cast<long>(mesh->size());
  EXPECT_EQ(vertices - static_cast<long>(edges.size()) + faces, 2);  // Euler
}

TEST(Polygons, OfARingHaveAHole) {
  const SolidTree ring =
      SolidTree(solid::Box{Vec3d(-1), Vec3d(1)}) - SolidTree(solid::Box{Vec3d(-0.5, -0.5, -2), Vec3d(0.5, 0.5, 2)});
  const auto mesh = polygons_of(one(ring), 12);
  const auto edges = edges_of(*mesh);
  EXPECT_EQ(static_cast<long>(mesh->positions().size()) - static_cast<long>(edges.size()) + mesh->size(), 0);
}

TEST(Polygons, LoseWhatIsThinnerThanACell) {
  const SolidTree slotted =
      SolidTree(solid::Box{Vec3d(0), Vec3d(1)}) - SolidTree(solid::Box{Vec3d(0.5, -1, -1), Vec3d(0.5 + 0x1p-10, 2, 2)});
  const auto mesh = polygons_of(one(slotted), 10);
  const auto edges = edges_of(*mesh);
  EXPECT_EQ(static_cast<long>(mesh->positions().size()) - static_cast<long>(edges.size()) + mesh->size(), 2);
}

TEST(BandShares, OfOneFrequencyAreAllOrNothing) {
  const auto wave = [](double cycles) {
    return band_shares([=](double x) { return std::sin(2 * std::numbers::pi * cycles * x + 0.3); });
  };
  EXPECT_LT(wave(1).above, 1e-6);
  EXPECT_LT(wave(1).below, 1e-6);
  EXPECT_GT(wave(1).octaves, 0.999);
  EXPECT_GT(wave(3).above, 0.999);
  EXPECT_GT(wave(0.125).below, 0.999);
}

TEST(BandShares, TakeNoNoticeOfTheMean) {
  const auto wave = [](double mean) { return [=](double x) { return mean + std::sin(7 * x); }; };
  EXPECT_NEAR(band_shares(wave(100)).below, band_shares(wave(0)).below, 1e-9);
  EXPECT_TRUE(std::isnan(band_shares([](double) { return 1.0; }).above));
}

}  // namespace
}  // namespace sightline::bench
