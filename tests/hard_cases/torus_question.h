#pragma once
/// Lines and tori, and all that the library says of them.

#include "sightline/math/random.h"
#include "sightline/shape/torus.h"
#include "tests/hard_cases/root_question.h"

namespace sightline::hard {

struct TorusAndRay {
  Torus torus;
  Ray<double> ray;
};

/// The same in another place, size, direction of space and speed, in numbers that are exact where those given are small
/// and whole: roots are shifted and divided.
TorusAndRay varied(const TorusAndRay& given, Random& random);

class TorusQuestion {
 public:
  explicit TorusQuestion(const TorusAndRay& given);

  const RootQuestion& roots() const { return roots_; }
  const SolidQuestion& solid() const { return solid_; }

  /// As a solid, all spans and the first boundary, at all levels; and torus_roots, which tells of touches, at those
  /// that promise to.
  void ask(Trial& trial) const;
  /// Among eight others, `apart` from each other and all away from the ray, by every structure.
  void ask_structures(Trial& trial, const Vec3d& apart) const;

  /// The polynomial along the ray from its origin, as it is often computed: in double.
  std::array<double, 5> naive_polynomial() const;

 private:
  TorusAndRay given_;
  RootQuestion roots_;
  SolidQuestion solid_;
};

}  // namespace sightline::hard
