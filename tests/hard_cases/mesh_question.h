#pragma once
/// Rays asked of every structure over a mesh, and what exact arithmetic says of them.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "sightline/query/tracer.h"
#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

/// A mesh, and every structure of the registry over it.
class TracedMesh {
 public:
  explicit TracedMesh(TriangleMesh mesh);

  const TriangleMesh& mesh() const { return *mesh_; }
  const std::vector<std::unique_ptr<Tracer>>& tracers() const { return tracers_; }

 private:
  std::shared_ptr<const TriangleMesh> mesh_;
  std::vector<std::unique_ptr<Tracer>> tracers_;
};

/// A triangle that a ray crosses.
struct TrueCrossing {
  std::uint32_t id;
  std::uint32_t rank;  ///< 0 where none is nearer; the same where t is the same real number.
  float t_float;       ///< The true t, rounded to nearest.
  double t;            ///< Likewise.
};

/// Those in (t_min, t_max], nearest first, equal ones by id. In integers of any length: the plane, then on which sides
/// of the edges the point is. Triangles without area, and those seen edge-on, are not crossed.
std::vector<TrueCrossing> true_crossings(const TriangleMesh& mesh, const Ray<double>& ray);

/// A test of a triangle as it is often written: t, or nothing.
using NaiveTest = std::optional<float> (*)(const Ray<float>&, const Triangle&);

struct Judged {
  Verdict verdict = Verdict::exact;
  double error = 0;  ///< Of t, relative.
};

class MeshQuestion {
 public:
  /// Refers to the mesh.
  MeshQuestion(const TriangleMesh& mesh, std::vector<Ray<float>> rays);

  std::span<const Ray<float>> rays() const { return rays_; }
  const std::vector<TrueCrossing>& truth(std::size_t i) const { return truths_[i]; }
  /// How many of the rays truly hit.
  std::size_t hits() const;

  /// Every structure, at every level: the nearest hit, whether there is one, and, of double rays, all of them.
  ///   fast, watertight: rays of float. precise: the same rays in double, decisions and numbers. exact: that t of the
  ///   nearest hit is the nearest double, of a triangle that has this t; and which triangles are crossed in all. The
  ///   order of what is less than a last place apart only triangle_crossings() has; it is asked as well.
  void ask(Trial& trial, const TracedMesh& traced) const;
  /// Brute force with that test.
  void ask(Tally& tally, NaiveTest test) const;
  /// Any answer: what some code found to be nearest of ray i.
  void judge(Tally& tally, std::size_t i, const Hit<float>& hit) const;

 private:
  template <class T>
  Judged judged(std::size_t i, const Hit<T>& hit, double share) const;
  template <class T>
  void judge_closest(Tally& tally, std::size_t i, const Hit<T>& hit, double share) const;
  void judge_any(Tally& tally, std::size_t i, bool is_hit) const;
  void judge_exact(Tally& tally, std::size_t i, const Hit<double>& hit, const std::vector<Hit<double>>& all) const;
  template <class T>
  void ask_numbers(Trial& trial, const Tracer& tracer, std::span<const Ray<T>> rays, Level level, double share) const;
  void ask_crossings(Trial& trial) const;
  template <class Got>
  Example example(std::size_t i, Got&& got) const;

  const TriangleMesh& mesh_;
  std::vector<Ray<float>> rays_;
  std::vector<Ray<double>> wide_;
  std::vector<std::vector<TrueCrossing>> truths_;
};

std::string text_of_number(double x);
std::string text_of_point(const Vec3d& p);
std::string text_of_ray(const Ray<double>& ray);

}  // namespace sightline::hard
