#include "bench/instances/field.h"

#include <algorithm>
#include <cmath>

#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/camera.h"

namespace sightline::bench {

std::shared_ptr<const Instances> field_of(const std::shared_ptr<const TriangleMesh>& mesh, std::uint32_t count) {
  const auto side = static_cast<std::uint32_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  const Vec3d extent(mesh->bounds().extent()), center(mesh->bounds().center());
  const double step = 1.25 * max_norm(extent);
  Random random(1);
  std::vector<Placement> placements;
  placements.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vec3d point = step * Vec3d(i % side, i / side % side, i / side / side);
    const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
    const Transform turn = Transform::rotation(Vec3d(x - 0.5, y - 0.5, z + 0.1), 360 * random.uniform_double());
    placements.push_back({(Transform::translation(point) * turn * Transform::translation(-center)).matrix(), 0});
  }
  return std::make_shared<const Instances>(std::vector{mesh}, std::move(placements));
}

std::vector<InstanceRays> instance_rays(const Instances& instances, std::size_t count) {
  const auto height = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count) * 3 / 4)));
  const auto width = std::max(1, static_cast<int>(count) / height);
  const Aabb all = instances.bounds();
  const Vec3f quarter = 0.25f * all.extent();
  return {{"camera", "of a camera that sees all", primary_rays(Camera::facing(all, width, height))},
          {"inside", "between random points of the middle",
           random_rays({all.center() - quarter, all.center() + quarter}, count, 2)}};
}

}  // namespace sightline::bench
