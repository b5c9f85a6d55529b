#include "sightline/scene/levels.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>

#include "sightline/scene/flatten.h"

namespace sightline {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Matrix = std::array<std::array<Rational, 4>, 4>;

Matrix operator*(const Matrix& outer, const Matrix& inner) {
  Matrix product{};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t j = 0; j < 4; ++j) product[i][k] += outer[i][j] * inner[j][k];
    }
  }
  return product;
}

Matrix diagonal(const Rational& x) {
  Matrix matrix{};
  for (std::size_t i = 0; i < 3; ++i) matrix[i][i] = x;
  matrix[3][3] = 1;
  return matrix;
}

Matrix moved(const Rational& x, const Rational& y) {
  Matrix matrix = diagonal(1);
  matrix[0][3] = x;
  matrix[1][3] = y;
  return matrix;
}

/// About y, counter-clockwise.
Matrix quarter_turns(int quarters) {
  Matrix turn = diagonal(1);
  Matrix quarter{};
  quarter[0][2] = 1;
  quarter[1][1] = 1;
  quarter[2][0] = -1;
  quarter[3][3] = 1;
  for (int i = 0; i < quarters; ++i) turn = quarter * turn;
  return turn;
}

void render_level(std::vector<Matrix>& spheres, const Matrix& current, int levels, const Matrix& turn) {
  spheres.push_back(current * diagonal(Rational(1, 2)));
  if (levels == 1) return;
  for (const int side : {1, -1}) {
    render_level(spheres, current * diagonal(Rational(3, 4)) * moved(side, Rational(-3, 4)) * turn, levels - 1, turn);
  }
}

TEST(Levels, PlaceSpheresByTheProductOfMatrices) {
  for (const int quarters : {0, 1, 2, 3}) {
    std::vector<Matrix> expected;
    render_level(expected, diagonal(1), 7, quarter_turns(quarters));
    const Scene scene = make_levels(7, 90 * quarters);
    const SceneInstances placed = instances_of(scene);
    ASSERT_EQ(placed.instances.size(), expected.size());
    for (std::uint32_t i = 0; i < expected.size(); ++i) {
      const Affine world = scene.graph.world(placed.origins[i].node).matrix();
      for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column) {
          ASSERT_EQ(Rational(world.rows[row][column]), expected[i][row][column]) << i;
          ASSERT_EQ(placed.instances.placements()[i].row(row)[column], static_cast<float>(world.rows[row][column]));
        }
      }
    }
  }
}

TEST(Levels, AreTurnedAsTheyAreMade) {
  Scene scene = make_levels(6);
  for (const double degrees : {30.0, -7.5, 1000.0, 0.0}) {
    turn_levels(scene, degrees);
    const SceneInstances turned = instances_of(scene), made = instances_of(make_levels(6, degrees));
    ASSERT_EQ(turned.instances.size(), 63u);
    ASSERT_EQ(made.instances.size(), 63u);
    for (std::size_t i = 0; i < 63; ++i) {
      EXPECT_EQ(turned.instances.placements()[i].to_world(), made.instances.placements()[i].to_world());
    }
  }
}

/// What is below a sphere moves with it; the first sphere stays.
TEST(Levels, Move) {
  const SceneInstances still = instances_of(make_levels(3)), turned = instances_of(make_levels(3, 30));
  EXPECT_EQ(still.instances.placements()[0].to_world(), turned.instances.placements()[0].to_world());
  for (std::size_t i = 2; i < 7; ++i) {
    EXPECT_NE(still.instances.placements()[i].to_world(), turned.instances.placements()[i].to_world());
  }
}

}  // namespace
}  // namespace sightline
