#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "sightline/math/random.h"
#include "sightline/math/transform.h"
#include "sightline/query/instance_tracer.h"
#include "sightline/query/moving_tracer.h"
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
  return {share(make_teapot(2)), share(make_integers(60)), share(make_menger(1))};
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

std::vector<std::shared_ptr<const Tracer>> tracers_of(const Instances& instances, std::string_view accelerator) {
  std::vector<std::shared_ptr<const Tracer>> tracers;
  for (const auto& mesh : instances.meshes()) tracers.push_back(make_tracer(accelerator, mesh));
  return tracers;
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
    const auto tracers = tracers_of(*instances, lower.name);
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

/// Frames of instances that each turn about their places.
std::shared_ptr<const Instances> frame(const std::vector<std::shared_ptr<const TriangleMesh>>& shared, int time) {
  Random random(11);
  std::vector<Placement> placements;
  for (std::uint32_t i = 0; i < 40; ++i) {
    const Transform place = Transform::translation(vector_in(random, -8, 8)) * turn(random);
    placements.push_back({(place * Transform::rotation({0, 1, 0}, 20 * time)).matrix(), i % 3});
  }
  return std::make_shared<const Instances>(shared, std::move(placements));
}

TEST(MovingTracer, FollowsWhatMovesWithTheSameHits) {
  const auto shared = meshes();
  const auto first = frame(shared, 0);
  for (const AcceleratorInfo& upper : accelerator_infos()) {
    const auto tracers = tracers_of(*first, "box-tree");
    MovingTracer refitted(std::string(upper.name), tracers, {}, MovePolicy::refit);
    MovingTracer rebuilt(std::string(upper.name), tracers, {}, MovePolicy::rebuild);
    for (int time = 0; time < 5; ++time) {
      SCOPED_TRACE(std::string(upper.name) + " at " + std::to_string(time));
      const auto instances = frame(shared, time);
      const InstanceTracer &a = refitted.move(instances), &b = rebuilt.move(instances);
      const auto rays = random_rays(instances->bounds(), 500, 5);
      std::vector<InstanceHit<float>> hits(rays.size()), expected(rays.size());
      a.closest_hits(rays, hits);
      b.closest_hits(rays, expected);
      EXPECT_TRUE(hits == expected);
    }
    EXPECT_EQ(rebuilt.counts().built, 5);
    const bool can_refit =
        upper.name == "box-tree" || upper.name == "wide-tree" || upper.name == "bih" || upper.name == "brute-force";
    EXPECT_EQ(refitted.counts().refitted, can_refit ? 4 : 0) << upper.name;
    EXPECT_EQ(refitted.counts().built, can_refit ? 1 : 5) << upper.name;
    // Others than before.
    const auto placements = first->placements();
    refitted.move(std::make_shared<const Instances>(shared, std::vector(placements.begin(), placements.begin() + 5)));
    EXPECT_EQ(refitted.counts().built, can_refit ? 2 : 6) << upper.name;
  }
}

TEST(RefitChoice, BuildsOnceTracingHasLostAsMuch) {
  RefitChoice choice;
  EXPECT_FALSE(choice.prefers_refitting());  // nothing is there yet
  choice.built(10);
  EXPECT_TRUE(choice.prefers_refitting());
  choice.traced(5);
  choice.refitted(1);
  for (const double tracing : {6.0, 4.0, 9.0, 8.0}) {  // 1, 0 and 4 and 3 slower than the first: 8 in all
    EXPECT_TRUE(choice.prefers_refitting());
    choice.traced(tracing);
  }
  EXPECT_TRUE(choice.prefers_refitting());
  choice.traced(6);
  EXPECT_FALSE(choice.prefers_refitting());
  choice.built(10);
  EXPECT_TRUE(choice.prefers_refitting());
}

TEST(Instances, RefuseWhatCannotBeTraced) {
  const auto shared = meshes();
  const auto refusal = [&](std::vector<Placement> placements) -> std::string {
    try {
      Instances(shared, std::move(placements));
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "taken";
  };
  const auto scaled = [](const Vec3d& by) {
    Affine map;
    for (int i = 0; i < 3; ++i) map.rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] = by[i];
    return map;
  };
  const Placement fine(Affine(), 0);
  EXPECT_EQ(refusal({fine, fine}), "taken");
  EXPECT_EQ(refusal({fine, {scaled({1, 0, 1}), 0}}), "instance 1: expected a matrix that can be inverted in float");
  EXPECT_EQ(refusal({{scaled({1, 1, 1e-60}), 0}}), "instance 0: expected a matrix that can be inverted in float");
  EXPECT_EQ(refusal({{scaled({1e60, 1, 1}), 0}}), "instance 0: expected a matrix of numbers that are finite in float");
  EXPECT_EQ(refusal({{scaled({3e38, 1, 1}), 0}}), "instance 0: expected vertices within the range of float");
  EXPECT_EQ(refusal({fine, fine, {Affine(), 3}}), "instance 2: expected a mesh below 3");
  EXPECT_THROW(Instances(shared, std::vector<Placement>(3, fine)).flattened(100), std::length_error);
  EXPECT_THROW(make_instance_tracer("kd-tree", frame(shared, 0), {}), std::invalid_argument);
  EXPECT_THROW(make_instance_tracer("kd", frame(shared, 0), tracers_of(*frame(shared, 0), "bih")),
               std::invalid_argument);
}

}  // namespace
}  // namespace sightline
