#pragma once

#include <array>

#include "sightline/math/affine.h"
#include "sightline/math/enclosure.h"

namespace sightline {

/// What holds the image of a thing under an affine map, of what holds the thing itself.
///   I1  Holds what real arithmetic makes of the map, and what Placement makes of it, which rounds the map's numbers
///       and places to float.
///   I2  Each kind is the best of what follows from the three kinds that hold the thing, so that a box of a ball is as
///       close as a ball of a box. A thing that is moved, turned, mirrored or scaled evenly is held as closely as
///       before by ball and cylinder, but for rounding.
class EnclosureImage {
 public:
  EnclosureImage(const Affine& map, const Enclosure& thing);

  Aabb box() const;
  Sphere sphere() const;
  Cylinder cylinder() const;

  template <class V>
  V get() const;

 private:
  struct Candidate;

  Candidate of_cylinder() const;
  Candidate of_box_along(int edge) const;

  Enclosure thing_;
  std::array<Vec3d, 3> columns_;  ///< Of the linear part, over `scale_`, so that no square leaves the range.
  std::array<Vec3d, 3> rows_;     ///< Likewise.
  double scale_ = 1;
  Vec3d translation_;
  Vec3d slack_;        ///< By axis: what I1 moves points by, and what roundings here may add.
  double slack_size_;  ///< Its length, or more.
};

template <>
inline Aabb EnclosureImage::get<Aabb>() const {
  return box();
}
template <>
inline Sphere EnclosureImage::get<Sphere>() const {
  return sphere();
}
template <>
inline Cylinder EnclosureImage::get<Cylinder>() const {
  return cylinder();
}

/// The largest factor by which a linear map stretches, or at most a hundredth more; exact but for rounding for
/// rotations and even scaling. Of columns whose largest number is between 1 and 2.
double stretch_of(const std::array<Vec3d, 3>& columns);

}  // namespace sightline
