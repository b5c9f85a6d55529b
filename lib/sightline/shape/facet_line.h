#pragma once
/// A line against triangles, decided as real arithmetic would.
///
/// Seen along the line, which is a point there, each edge from a to b has that point on its left, on its right or on
/// itself: the sign of direction . ((a - origin) x (b - origin)), the edge function. Its terms are computed in double
/// after a shear that makes the line an axis (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013);
/// what the error bound does not settle, balls and then exact numbers do.
///   E1  The edge function of b to a is that of a to b negated, so that triangles agree about the edge they share.
///   E2  Those of a triangle sum up to direction . normal, the normal being (b - a) x (c - a).

#include "sightline/math/ball.h"
#include "sightline/shape/facet.h"
#include "sightline/shape/line.h"

namespace sightline {

class FacetLine {
 public:
  /// All vertices that will be asked about are in the box from `lo` to `hi`. Refers to what the ray does.
  FacetLine(const FramedRay& ray, const Vec3d& lo, const Vec3d& hi);

  /// How the line goes through the triangle: 1 the way its outward normal points, -1 the other way, 0 not at all.
  /// Decided for the line moved aside by infinitesimals: by e along one axis and by e^2 along another, neither being
  /// the axis along which its direction is largest. So it meets no edge and no vertex, and goes through a closed
  /// surface as often one way as the other. Triangles that are parallel to the line, or without area, it never passes.
  /// Edelsbrunner and Muecke, "Simulation of Simplicity", 1990.
  int passage(const solid::Facet&) const;

  /// Whether the line as it is meets the closed triangle, edges and vertices included, in a single point. So none that
  /// is parallel to the line, though the line may lie in it, and none without area.
  bool crosses(const solid::Facet&) const;

  /// A vertex as seen along the line, which is the point (0, 0).
  struct Seen {
    double x, y;
  };
  Seen see(const Vec3d& p) const {
    const double z = p[z_axis_] - origin_[z_axis_];
    return {p[x_axis_] - origin_[x_axis_] - shear_x_ * z, p[y_axis_] - origin_[y_axis_] - shear_y_ * z};
  }

  /// The coordinates of what is seen are off by at most this; infinite where nothing is known of them.
  double error() const { return error_; }
  /// The coordinate axes that x and y belong to, and the one along which the direction is largest.
  int x_axis() const { return x_axis_; }
  int y_axis() const { return y_axis_; }
  int z_axis() const { return z_axis_; }
  /// How much x and y change with z.
  double shear_x() const { return shear_x_; }
  double shear_y() const { return shear_y_; }

 private:
  /// Of the edges from each vertex to the next, times the direction's z; 0 is not known.
  struct Signs {
    std::array<int, 3> of;
  };
  enum class Verdict { outside, unknown, all_alike };

  Verdict look(const solid::Facet&, Signs&) const;
  int edge_sign(const Vec3d& a, const Vec3d& b) const;
  int moved_edge_sign(const Vec3d& a, const Vec3d& b) const;

  FramedRay ray_;
  Vec3d origin_{0};
  int x_axis_ = 0, y_axis_ = 1, z_axis_ = 2;
  int facing_ = 0;  ///< The sign of the direction's z; 0 where there is no direction.
  double shear_x_ = 0, shear_y_ = 0;
  double error_;
};

}  // namespace sightline
