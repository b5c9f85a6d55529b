#include "bench/peers/cgal.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <type_traits>
#include <vector>

#include "bench/peers/heap.h"

namespace sightline::bench {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree =
    CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>>>;

Point to_point(const Vec3d& p) { return {p.x, p.y, p.z}; }

class BuiltCgal final : public Built {
 public:
  explicit BuiltCgal(const TriangleMesh& mesh) {
    const std::size_t before = heap_bytes();
    triangles_.reserve(mesh.size());
    for (std::uint32_t i = 0; i < mesh.size(); ++i) {
      const Triangle triangle = mesh[i];
      triangles_.emplace_back(to_point(Vec3d(triangle.a)), to_point(Vec3d(triangle.b)), to_point(Vec3d(triangle.c)));
    }
    tree_.insert(triangles_.cbegin(), triangles_.cend());
    tree_.build();
    bytes_ = heap_bytes() - before;
  }

  void closest_hits(std::span<const Ray<float>> rays, std::span<Hit<float>> hits) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = closest_hit(rays[i]);
  }

  void any_hits(std::span<const Ray<float>> rays, std::span<std::uint8_t> is_hit) const override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Ray<float>& ray = rays[i];
      is_hit[i] = std::isinf(ray.t_max) ? tree_.do_intersect(to_cgal(ray))
                                        : tree_.do_intersect(Kernel::Segment_3(at(ray, ray.t_min), at(ray, ray.t_max)));
    }
  }

  Bytes bytes() const override { return {bytes_, std::nullopt}; }

 private:
  static Point at(const Ray<float>& ray, float t) {
    return to_point(Vec3d(ray.origin) + static_cast<double>(t) * Vec3d(ray.direction));
  }
  static Kernel::Ray_3 to_cgal(const Ray<float>& ray) {
    return {at(ray, ray.t_min), Kernel::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z)};
  }

  /// A ray in the triangle's plane meets it in a segment, whose nearer end counts.
  Hit<float> closest_hit(const Ray<float>& ray) const {
    const auto found = tree_.first_intersection(to_cgal(ray));
    if (!found) return {};
    const Vec3d size = glm::abs(Vec3d(ray.direction));
    const int axis = largest_axis(size);
    const auto t_of = [&](const Point& p) { return (p[axis] - ray.origin[axis]) / ray.direction[axis]; };
    double t = 0;
    if (const auto* point = boost::get<Point>(&found->first)) {
      t = t_of(*point);
    } else if (const auto* segment = boost::get<Kernel::Segment_3>(&found->first)) {
      t = std::fmin(t_of(segment->source()), t_of(segment->target()));
    }
    if (t > ray.t_max) return {};
    return {static_cast<float>(t), static_cast<std::uint32_t>(found->second - triangles_.cbegin()), 0, 0};
  }

  Triangles triangles_;
  Tree tree_;
  std::size_t bytes_ = 0;
};

class Cgal final : public Contender {
 public:
  std::string name() const override { return "cgal"; }
  Kind kind() const override { return Kind::peer; }
  std::unique_ptr<Built> build(const std::shared_ptr<const TriangleMesh>& mesh) const override {
    return std::make_unique<BuiltCgal>(*mesh);
  }
};

}  // namespace

std::unique_ptr<Contender> make_cgal() { return std::make_unique<Cgal>(); }

}  // namespace sightline::bench
