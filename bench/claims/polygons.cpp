#include "bench/claims/polygons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sightline::bench {
namespace {

/// Corners of a cell by the axes along which they are one step on, as bits; a tetrahedron's add one after the other.
constexpr std::array<std::array<unsigned, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 1, 5, 7}, {0, 2, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 4, 6, 7}}};

Vec3d steps_of(unsigned corner) { return Vec3d(corner & 1, corner >> 1 & 1, corner >> 2 & 1); }

class Lattice {
 public:
  Lattice(const OneSolid& solid, int cells) : solid_(solid) {
    const Aabb box = solid.bounds(0);
    const Vec3d extent = Vec3d(box.hi) - Vec3d(box.lo);
    width_ = max_norm(extent) / cells;
    // Not in step with the solid, whose faces often are where lattices have their planes.
    origin_ = Vec3d(box.lo) - width_ * Vec3d(0.611, 0.553, 0.587);
    for (int axis = 0; axis < 3; ++axis) counts_[axis] = static_cast<std::size_t>(std::ceil(extent[axis] / width_)) + 3;
    fill();
  }

  std::shared_ptr<const TriangleMesh> march() {
    for (std::size_t z = 0; z + 1 < counts_[2]; ++z) {
      for (std::size_t y = 0; y + 1 < counts_[1]; ++y) {
        for (std::size_t x = 0; x + 1 < counts_[0]; ++x) march_cell(index(x, y, z));
      }
    }
    return std::make_shared<const TriangleMesh>(std::move(positions_), std::move(triangles_));
  }

 private:
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const { return x + counts_[0] * (y + counts_[1] * z); }
  std::size_t index_at(std::size_t cell, unsigned corner) const {
    return cell + index(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
  }
  Vec3d place(std::size_t at) const {
    const std::size_t x = at % counts_[0], y = at / counts_[0] % counts_[1], z = at / counts_[0] / counts_[1];
    return origin_ + width_ * Vec3d(x, y, z);
  }

  /// Which points are inside: a ray along each row tells of all of it.
  void fill() {
    is_inside_.resize(counts_[0] * counts_[1] * counts_[2]);
    for (std::size_t z = 0; z < counts_[2]; ++z) {
      for (std::size_t y = 0; y < counts_[1]; ++y) {
        const std::size_t row = index(0, y, z);
        bool is_inside = false;
        std::size_t x = 0;
        const auto up_to = [&](double t) {
          for (; x < counts_[0] && static_cast<double>(x) < t; ++x) is_inside_[row + x] = is_inside;
        };
        solid_.prepare({place(row), Vec3d(width_, 0, 0)}).for_each_crossing(solid_[0], [&](const Crossing& crossing) {
          up_to(crossing.t);
          is_inside = !is_inside;
        });
        up_to(static_cast<double>(counts_[0]));
      }
    }
  }

  /// On the edge from a point to another that is `along` it. One is inside and one is not.
  std::uint32_t vertex(std::size_t from, unsigned along) {
    const auto [at, is_new] = vertices_.try_emplace(8 * from + along, static_cast<std::uint32_t>(positions_.size()));
    if (is_new) {
      const Ray<double> edge{place(from), width_ * steps_of(along)};
      double first = 0.5;  // where rounding has the two points agree after all
      bool is_found = false;
      solid_.prepare(edge).for_each_crossing(solid_[0], [&](const Crossing& crossing) {
        if (is_found || !(crossing.t > 0 && crossing.t <= 1)) return;
        first = crossing.t;
        is_found = true;
      });
      positions_.push_back(Vec3f(edge.at(first)));
    }
    return at->second;
  }

  void march_cell(std::size_t cell) {
    unsigned inside = 0;
    for (unsigned corner = 0; corner < 8; ++corner) inside |= unsigned(is_inside_[index_at(cell, corner)]) << corner;
    if (inside == 0 || inside == 255) return;
    for (const std::array<unsigned, 4>& corners : tetrahedra) {
      std::array<unsigned, 4> in{}, out{};
      std::size_t in_count = 0, out_count = 0;
      for (const unsigned corner : corners) {
        if (inside >> corner & 1)
          in[in_count++] = corner;
        else
          out[out_count++] = corner;
      }
      const auto between = [&](unsigned a, unsigned b) {
        if ((a & b) != a) std::swap(a, b);
        return vertex(index_at(cell, a), a ^ b);
      };
      if (in_count == 1 || out_count == 1) {
        const unsigned lone = in_count == 1 ? in[0] : out[0];
        const std::array<unsigned, 4>& others = in_count == 1 ? out : in;
        triangles_.push_back({between(lone, others[0]), between(lone, others[1]), between(lone, others[2])});
      } else if (in_count == 2) {
        const std::uint32_t a = between(in[0], out[0]), b = between(in[0], out[1]), c = between(in[1], out[1]),
                            d = between(in[1], out[0]);
        triangles_.push_back({a, b, c});
        triangles_.push_back({a, c, d});
      }
    }
  }

  const OneSolid& solid_;
  double width_;
  Vec3d origin_;
  std::array<std::size_t, 3> counts_;
  std::vector<std::uint8_t> is_inside_;
  std::unordered_map<std::size_t, std::uint32_t> vertices_;
  std::vector<Vec3f> positions_;
  std::vector<TriangleMesh::Corners> triangles_;
};

}  // namespace

std::shared_ptr<const TriangleMesh> polygons_of(const OneSolid& solid, int cells) {
  return Lattice(solid, cells).march();
}

}  // namespace sightline::bench
