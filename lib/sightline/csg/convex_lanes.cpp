#include "sightline/csg/convex_lanes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sightline {

class ConvexLanes::Builder {
 public:
  Builder(ConvexLanes& lanes, std::span<const Primitive> primitives) : lanes_(lanes), primitives_(primitives) {}

  bool keep(std::uint32_t primitive) {
    const bool is_held = std::visit(
        [&]<class S>(const S& shape) {
          if constexpr (std::is_same_v<S, solid::Box>) {
            for (std::uint32_t face = 0; face < 6; ++face) bound({primitive, face, solid::face_of(shape, face)});
            return true;
          } else if constexpr (std::is_same_v<S, solid::Cylinder>) {
            const int axis = axis_across(cap_of(shape, true));
            for (const bool is_top : {false, true}) {
              const bool is_upper = (shape.top[std::max(axis, 0)] > shape.base[std::max(axis, 0)]) == is_top;
              if (axis >= 0)
                bound({primitive, is_top ? 2u : 1u, {axis, (is_top ? shape.top : shape.base)[axis], is_upper}});
            }
            return axis >= 0 && add_round(primitive, shape, axis);
          } else if constexpr (std::is_same_v<S, solid::Sphere>) {
            return add_round(primitive, shape, -1);
          } else {
            return false;
          }
        },
        primitives_[primitive].shape);
    lanes_.kept_count_ = lanes_.count_;
    return is_held && is_ordered_;
  }

  bool take(std::uint32_t primitive) {
    return std::visit(
        [&]<class S>(const S& shape) {
          if constexpr (std::is_same_v<S, solid::Box>) {
            if (!begin_lane(primitive)) return false;
            for (int axis = 0; axis < 3; ++axis) slab(axis, shape.lo[axis], shape.hi[axis]);
            lane().is_box = true;
            return true;
          } else if constexpr (std::is_same_v<S, solid::Cylinder>) {
            const int axis = axis_across(cap_of(shape, true));
            if (axis < 0 || !add_round(primitive, shape, axis)) return false;
            slab(axis, std::min(shape.base[axis], shape.top[axis]), std::max(shape.base[axis], shape.top[axis]));
            lane().goes_up = shape.top[axis] > shape.base[axis];
            lane().cap_axis = axis;
            return true;
          } else if constexpr (std::is_same_v<S, solid::Sphere>) {
            return add_round(primitive, shape, -1);
          } else {
            return false;
          }
        },
        primitives_[primitive].shape);
  }

 private:
  struct Side {
    std::uint32_t primitive, face;
    solid::AxisPlane plane;
  };

  Lane& lane() { return lanes_.lanes_[lanes_.count_ - 1]; }
  std::size_t last() const { return lanes_.count_ - 1; }

  bool begin_lane(std::uint32_t primitive) {
    if (lanes_.count_ == capacity) return false;
    lanes_.lanes_[lanes_.count_++].primitive = primitive;
    return true;
  }

  void bound(const Side& side) {
    const auto axis = static_cast<std::size_t>(side.plane.axis);
    const bool is_upper = side.plane.is_upper;
    const double position = side.plane.position;
    double& inner = (is_upper ? lanes_.doubles_.upper : lanes_.doubles_.lower)[axis];
    float& rounded = (is_upper ? lanes_.floats_.upper : lanes_.floats_.lower)[axis];
    is_ordered_ = is_ordered_ && static_cast<float>(position) != rounded;  // C1
    if (is_upper ? position >= inner : position <= inner) return;
    inner = position, rounded = static_cast<float>(position);
    lanes_.planes_[2 * axis + is_upper] = {side.primitive, side.face};
  }

  void slab(int axis, double lo, double hi) {
    const auto i = static_cast<std::size_t>(axis);
    lanes_.doubles_.lo[i][last()] = lo, lanes_.doubles_.hi[i][last()] = hi;
    lanes_.floats_.lo[i][last()] = static_cast<float>(lo), lanes_.floats_.hi[i][last()] = static_cast<float>(hi);
    lanes_.has_slabs_ = true;
  }

  /// Around the point `center`, or around the line through it along `axis`.
  template <class S>
  bool add_round(std::uint32_t primitive, const S& shape, int axis) {
    if (!begin_lane(primitive)) return false;
    lane().is_round = true;
    lanes_.round_bits_ |= 1u << last();
    fill_round(lanes_.doubles_, shape, axis);
    fill_round(lanes_.floats_, shape, axis);
    // Depths are of the form, not of the numbers.
    const auto form = solid::form_of(shape, Line<SizedDouble>{});
    const auto share = [](const SizedDouble& x) { return x.depth * (0x1p-53 * (1 + 0x1p-40)); };
    lanes_.doubles_.error_a[last()] = share(form.a);
    lanes_.doubles_.error_b[last()] = share(form.b);
    lanes_.doubles_.error_c[last()] = share(form.c);
    return true;
  }

  template <class Real, class S>
  void fill_round(LaneRows<Real>& rows, const S& shape, int axis) const {
    const auto real = [](double x) { return static_cast<Real>(x); };
    const Real radius = real(shape.radius);
    Real length = 1;
    Vec3d center;
    if constexpr (std::is_same_v<S, solid::Cylinder>) {
      length = std::fabs(real(shape.top[axis]) - real(shape.base[axis]));
      center = shape.base;
    } else {
      center = shape.center;
    }
    for (int i = 0; i < 3; ++i) {
      rows.weight[static_cast<std::size_t>(i)][last()] = i == axis ? 0 : length;
      rows.center[static_cast<std::size_t>(i)][last()] = real(center[i]);
    }
    rows.is_round[last()] = 1;
    rows.square[last()] = radius * radius * (length * length);
    rows.radius_square[last()] = radius * radius;
  }

  ConvexLanes& lanes_;
  std::span<const Primitive> primitives_;
  bool is_ordered_ = true;
};

std::shared_ptr<const ConvexLanes> ConvexLanes::build(std::span<const Primitive> primitives,
                                                      std::span<const std::uint32_t> kept,
                                                      std::span<const std::uint32_t> taken) {
  auto lanes = std::make_shared<ConvexLanes>();
  Builder builder(*lanes, primitives);
  const bool are_held =
      std::all_of(kept.begin(), kept.end(), [&](std::uint32_t primitive) { return builder.keep(primitive); }) &&
      std::all_of(taken.begin(), taken.end(), [&](std::uint32_t primitive) { return builder.take(primitive); });
  return are_held ? lanes : nullptr;
}

}  // namespace sightline
