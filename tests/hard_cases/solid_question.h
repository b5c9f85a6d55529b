#pragma once
/// A ray asked of a solid at every level, held against real arithmetic.

#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "sightline/csg/solid.h"
#include "sightline/math/ray.h"
#include "tests/hard_cases/hard_case.h"

namespace sightline::hard {

/// A real number, known by its sign less the sum of two doubles, which is not rounded.
using TrueNumber = std::function<int(double, double)>;

/// Where a line is in a solid, truly.
struct TrueSpans {
  bool begins_inside = false;
  std::vector<TrueNumber> ends;
  std::vector<double> nearest;  ///< The ends, each rounded to the nearest double.

  void round_ends();
};

/// Whether x is the float, or the double, nearest to the number, and the even one of two.
bool is_nearest(const TrueNumber& number, float x);
bool is_nearest(const TrueNumber& number, double x);

/// By rationals and square roots compared without rounding: csg/exact_solid.h.
TrueSpans true_solid_spans(const SolidTree& tree, const Ray<double>& ray);
/// By Sturm's chain of the polynomial along the ray, in rationals.
TrueSpans sturm_sphere_spans(const solid::Sphere& sphere, const Ray<double>& ray);

/// The same union once a structure, which finds its operands. Of fewer than eight there would be none.
class UnionByStructure {
 public:
  explicit UnionByStructure(std::vector<SolidTree> operands);

  struct One {
    std::string_view structure;
    Solid solid;
  };
  const SolidTree& tree() const { return tree_; }
  std::span<const One> all() const { return all_; }

 private:
  SolidTree tree_;
  std::vector<One> all_;
};

/// Nine such solids on a lattice around the one that is meant, `apart` from each other, so that it needs to be found.
UnionByStructure among_others(const std::function<SolidTree(const Vec3d& at)>& solid, double apart);

/// Numbers count as within the bound where the error is no larger than
///   fast        2^-19 of the distance to the farthest part of the solid, as M1 of accel/padded_ray.h asks of it; where
///               a solid goes on without end, of the distance to the crossing,
///   watertight  2^-46 of the number (lib/README.md),
///   precise     the last place of the number, 2^-52 of it at most (ibid.),
///   exact       what rounding to nearest leaves.
/// Rounded to nearest is to float at `fast`, whose numbers are floats, and to double elsewhere.
class SolidQuestion {
 public:
  SolidQuestion(SolidTree tree, const Ray<double>& ray) : SolidQuestion(tree, ray, true_solid_spans(tree, ray)) {}
  SolidQuestion(SolidTree tree, const Ray<double>& ray, TrueSpans truth);

  const TrueSpans& truth() const { return truth_; }
  const Ray<double>& ray() const { return ray_; }
  /// As a parameter of the ray: where a part as far as the farthest of the solid may be.
  double reach() const { return reach_of(ray_.origin, solid_.bounds()) / max_norm(ray_.direction); }
  /// Ahead of the origin.
  std::optional<std::size_t> first_end() const;

  /// All spans, at all levels.
  void ask_spans(Trial& trial, std::string_view who) const;
  void ask_spans(Trial& trial, const UnionByStructure& solids) const;
  /// The first boundary with t > 0, at all levels.
  void ask_first(Trial& trial, std::string_view who) const;
  /// The same of the ray among fifteen neighbours, through a structure that takes packets, and whether there is one.
  /// Solids that are empty or have no bounds cannot be asked so: nothing is added.
  void ask_packet(Trial& trial, std::string_view who) const;
  /// The same of the ray alone through every structure, by its name.
  void ask_each_structure(Trial& trial) const;

  /// Crossings of a primitive in double, without a level, by M1 of accel/padded_ray.h: off by no more than 2^-35 of the
  /// distance to the farthest part of the solid.
  void judge_crossings(Tally& tally, std::span<const double> ends) const;

  /// Answers of other code, which promises nothing: a number is within the bound where it is off by no more than 2^-19
  /// of itself, 32 roundings of float.
  void judge_spans(Tally& tally, std::span<const double> ends) const;
  void judge_first(Tally& tally, std::optional<double> t) const;

 private:
  using Rule = Verdict (SolidQuestion::*)(std::size_t end, double t, Level level) const;

  void judge(Tally& tally, bool begins_inside, std::span<const double> ends, Level level, Rule rule) const;
  void judge_first(Tally& tally, std::optional<double> t, Level level, Rule rule) const;
  Verdict verdict_of(std::size_t end, double t, Level level) const;
  Verdict verdict_of_crossing(std::size_t end, double t, Level) const;
  Verdict verdict_of_naive(std::size_t end, double t, Level) const;
  bool is_primitive() const;  ///< Of structures.
  void judge_hit(Tally& tally, const Hit<double>& hit, bool is_hit, Level level) const;
  Example example(const std::string& expected, std::span<const double> got) const;

  SolidTree tree_;
  Solid solid_;
  Ray<double> ray_;
  TrueSpans truth_;
};

/// All digits, as people write them.
std::string all_digits(double x);
std::string all_digits(std::span<const double> numbers);

}  // namespace sightline::hard
