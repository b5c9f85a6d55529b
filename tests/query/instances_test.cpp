#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/query/instance_tracer.h"
#include "sightline/query/workloads.h"
#include "sightline/scene/procedural.h"
#include "sightline/scene/teapot.h"

namespace sightline {
namespace {

Vec3d vector_in(Random& random, double lo, double hi) {
  const double x = random.uniform_double(), y = random.uniform_double(), z = random.uniform_double();
  return lo + (hi - lo) * Vec3d(x, y, z);
}

Transform turn(Random& random) {
  return Transform::rotation(vector_in(random, -1, 1) + Vec3d(0, 0, 2), 360 * random.uniform_double());
}

using Place = Affine (*)(Random&);

struct Kind {
  const char* name;
  Place place;
};

/// What placements may be like. Coordinates of all of them are some units long, or a multiple where the name says so.
const Kind kinds[] = {
    {"rigid", [](Random& r) { return (Transform::translation(vector_in(r, -6, 6)) * turn(r)).matrix(); }},
    {"whole", [](Random& r) { return Transform::translation(glm::floor(vector_in(r, -4, 4))).matrix(); }},
    {"scaled",
     [](Random& r) {
       const Vec3d size = 0.05 + vector_in(r, 0, 1) * vector_in(r, 0, 1);
       return (Transform::translation(vector_in(r, -4, 4)) * turn(r) * Transform::scaling(size)).matrix();
     }},
    {"mirrored",
     [](Random& r) {
       const Vec3d size(r.below(2) ? -1 : 1, r.below(2) ? -0.5 : 2, r.below(2) ? -1 : 1);
       return (Transform::translation(vector_in(r, -4, 4)) * turn(r) * Transform::scaling(size)).matrix();
     }},
    {"hundred to one",
     [](Random& r) {
       Vec3d size(1);
       size[static_cast<int>(r.below(3))] = 0.01;
       return (Transform::translation(vector_in(r, -4, 4)) * turn(r) * Transform::scaling(size)).matrix();
     }},
    {"sheared",
     [](Random& r) {
       Affine shear;
       shear.rows[0][1] = 20 * r.uniform_double() - 10;
       shear.rows[1][2] = 2 * r.uniform_double() - 1;
       return Transform::translation(vector_in(r, -6, 6)).matrix() * turn(r).matrix() * shear;
     }},
    {"nearly singular",
     [](Random& r) {
       Affine map;  // three rows that are almost one
       const Vec3d row = vector_in(r, 0.5, 1);
       for (std::size_t i = 0; i < 3; ++i) {
         for (int k = 0; k < 3; ++k) {
           const auto column = static_cast<std::size_t>(k);
           map.rows[i][column] = row[k] + (i == column ? std::ldexp(1.0, -static_cast<int>(5 + r.below(18))) : 0);
         }
         map.rows[i][3] = 4 * r.uniform_double();
       }
       return map;
     }},
    {"far away",
     [](Random& r) {
       return (Transform::translation(Vec3d(1 << 14, 3 << 13, -(1 << 15)) + vector_in(r, -4, 4)) * turn(r)).matrix();
     }},
    {"tiny",
     [](Random& r) {
       return (Transform::translation(vector_in(r, -4, 4) * 0x1p-100) * turn(r) * Transform::scaling(Vec3d(0x1p-100)))
           .matrix();
     }},
    {"huge",
     [](Random& r) {
       return (Transform::translation(vector_in(r, -4, 4) * 0x1p+90) * turn(r) * Transform::scaling(Vec3d(0x1p+90)))
           .matrix();
     }},
};

std::vector<std::shared_ptr<const TriangleMesh>> meshes() {
  const auto share = [](TriangleMesh mesh) { return std::make_shared<const TriangleMesh>(std::move(mesh)); };
  return {share(make_teapot(2)), share(make_lattice(60)), share(make_menger(1))};
}

std::shared_ptr<const Instances> some_instances(const Kind& kind, std::uint64_t seed, int count) {
  Random random(seed);
  std::vector<Placement> placements;
  for (int i = 0; i < count; ++i) placements.push_back({kind.place(random), random.below(3)});
  return std::make_shared<const Instances>(meshes(), std::move(placements));
}

/// As wide a choice as can be had: through the scene, at edges of its triangles, and from within single instances.
std::vector<Ray<float>> rays_of(const Instances& instances, const TriangleMesh& flat, std::size_t count) {
  std::vector<Ray<float>> rays = random_rays(instances.bounds(), count, 1);
  const auto edges = edge_rays(flat, count, 2);
  rays.insert(rays.end(), edges.begin(), edges.end());
  for (std::uint32_t i = 0; i < instances.size(); ++i) {
    const auto near = random_rays(instances.bounds(i), count / instances.size() + 1, i);
    rays.insert(rays.end(), near.begin(), near.end());
  }
  Random random(3);
  for (std::size_t i = 0; i < rays.size(); i += 3) {
    rays[i].t_min = random.uniform();
    rays[i].t_max = rays[i].t_min + random.uniform();
  }
  return rays;
}

template <class T>
std::vector<Ray<T>> as(const std::vector<Ray<float>>& rays) {
  std::vector<Ray<T>> wide;
  for (const Ray<float>& ray : rays) {
    wide.push_back({Vec3<T>(ray.origin), Vec3<T>(ray.direction), T(ray.t_min), T(ray.t_max)});
  }
  return wide;
}

/// Hits of instances as hits of the flattened mesh.
template <class T>
Hit<T> flattened(const InstanceHit<T>& hit, const std::vector<std::uint32_t>& first) {
  return {hit.t, hit.is_hit() ? first[hit.instance] + hit.prim_id : no_primitive, hit.u, hit.v};
}

class InstancesTest : public testing::TestWithParam<Kind> {};

template <class T>
std::size_t compare(const InstanceTracer& two_levels, const Tracer& flat, const std::vector<Ray<float>>& narrow,
                    Level level) {
  std::vector<std::uint32_t> first{0};
  for (std::uint32_t i = 0; i < two_levels.instances().size(); ++i) {
    first.push_back(first.back() + two_levels.instances().mesh_of(i).size());
  }
  const std::vector<Ray<T>> rays = as<T>(narrow);
  std::vector<InstanceHit<T>> hits(rays.size());
  std::vector<Hit<T>> expected(rays.size());
  std::vector<std::uint8_t> is_hit(rays.size());
  two_levels.closest_hits(rays, hits, level);
  two_levels.any_hits(rays, is_hit, level);
  flat.closest_hits(rays, expected, level);
  std::size_t found = 0, wrong = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    found += expected[i].is_hit();
    wrong += flattened(hits[i], first) != expected[i] || (is_hit[i] != 0) != expected[i].is_hit();
  }
  EXPECT_EQ(wrong, 0u) << "of " << rays.size() << " rays, " << found << " of which hit";
  return found;
}

TEST_P(InstancesTest, HitsAreThoseOfTheFlattenedMesh) {
  const auto instances = some_instances(GetParam(), 7, 12);
  const auto mesh = std::make_shared<const TriangleMesh>(instances->flattened());
  ASSERT_EQ(mesh->size(), instances->triangles());
  ASSERT_EQ(mesh->bounds(), instances->bounds());
  const auto flat = make_tracer("brute-force", mesh);
  const auto rays = rays_of(*instances, *mesh, 100);
  for (const AcceleratorInfo& lower : accelerator_infos()) {
    std::vector<std::shared_ptr<const Tracer>> tracers;
    for (const auto& each : instances->meshes()) tracers.push_back(make_tracer(lower.name, each));
    for (const AcceleratorInfo& upper : accelerator_infos()) {
      SCOPED_TRACE(std::string(upper.name) + " of " + std::string(lower.name));
      const auto two_levels = make_instance_tracer(upper.name, instances, tracers);
      EXPECT_GT(compare<float>(*two_levels, *flat, rays, Level::watertight), rays.size() / 20);
      compare<float>(*two_levels, *flat, rays, Level::fast);
      compare<double>(*two_levels, *flat, rays, Level::watertight);
      if (HasFailure()) return;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Placements, InstancesTest, testing::ValuesIn(kinds), [](const auto& kind) {
  std::string name;
  for (const char* c = kind.param.name; *c; ++c) name += *c == ' ' ? '_' : *c;
  return name;
});

}  // namespace
}  // namespace sightline
