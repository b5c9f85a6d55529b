#include "viz/walk/coarse_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace sightline::viz {
namespace {

constexpr std::uint64_t axis_bits = 21;

std::uint64_t grid_cell(const Aabb& bounds, const Vec3f& p, double size) {
  std::uint64_t key = 0;
  for (int axis = 0; axis < 3; ++axis) {
    // Positions lie within the bounds, so that this is neither negative nor large.
    const double at = (double(p[axis]) - double(bounds.lo[axis])) / size;
    key = (key << axis_bits) | static_cast<std::uint64_t>(std::clamp(at, 0.0, double((1 << axis_bits) - 1)));
  }
  return key;
}

TriangleMesh clustered(const TriangleMesh& mesh, double size) {
  const auto& positions = mesh.positions();
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order(positions.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = {grid_cell(mesh.bounds(), positions[i], size), i};
  std::ranges::sort(order);
  std::vector<std::uint32_t> cluster(positions.size());
  std::vector<Vec3f> means;
  for (std::size_t first = 0; first < order.size();) {
    Vec3d sum(0);
    std::size_t last = first;
    for (; last < order.size() && order[last].first == order[first].first; ++last) {
      sum += Vec3d(positions[order[last].second]);
      cluster[order[last].second] = static_cast<std::uint32_t>(means.size());
    }
    means.emplace_back(sum / double(last - first));
    first = last;
  }
  std::vector<TriangleMesh::Corners> triangles;
  for (const auto& corners : mesh.triangles()) {
    TriangleMesh::Corners kept = {cluster[corners[0]], cluster[corners[1]], cluster[corners[2]]};
    if (kept[0] == kept[1] || kept[1] == kept[2] || kept[2] == kept[0]) continue;
    std::rotate(kept.begin(), std::ranges::min_element(kept), kept.end());
    triangles.push_back(kept);
  }
  std::ranges::sort(triangles);
  triangles.erase(std::ranges::unique(triangles).begin(), triangles.end());
  return {std::move(means), std::move(triangles)};
}

TriangleMesh thinned(const TriangleMesh& mesh, std::size_t most) {
  const std::size_t stride = (mesh.size() + most - 1) / most;
  std::vector<Vec3f> positions;
  std::vector<TriangleMesh::Corners> triangles;
  for (std::size_t i = 0; i < mesh.size(); i += stride) {
    const auto first = static_cast<std::uint32_t>(positions.size());
    for (const std::uint32_t corner : mesh.triangles()[i]) positions.push_back(mesh.positions()[corner]);
    triangles.push_back({first, first + 1, first + 2});
  }
  return {std::move(positions), std::move(triangles)};
}

}  // namespace

TriangleMesh coarse_mesh(const TriangleMesh& mesh, std::size_t most) {
  if (mesh.size() <= most) return mesh;
  // A surface across a grid of n cells an axis meets some n * n of them, and leaves two triangles in each.
  double cells = std::sqrt(double(most) / 2) * 1.4;
  TriangleMesh coarse = clustered(mesh, double(max_norm(mesh.bounds().extent())) / cells);
  while (coarse.size() > most) {
    cells *= 0.95 * std::sqrt(double(most) / coarse.size());
    coarse = clustered(mesh, double(max_norm(mesh.bounds().extent())) / cells);
  }
  return coarse.size() * 8 >= most ? coarse : thinned(mesh, most);
}

}  // namespace sightline::viz
