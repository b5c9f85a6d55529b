#pragma once
/// How a rocket flies; its shape is told elsewhere, and may be any.

#include "sightline/scene/controller.h"

namespace sightline {

/// From rest at the origin, by a steady acceleration while it burns, then as it was thrown, until it is back at y = 0.
/// Points where it flies, and rolls. Meters and seconds.
struct RocketFlight {
  double burning = 3;             ///< How long.
  Vec3d acceleration{0.5, 4, 0};  ///< While it burns, gravity included; upward.
  double gravity = 9.81;          ///< Downward, from then on.
  double roll = 45;               ///< Degrees a second.

  bool is_burning(double time) const { return time > 0 && time < burning; }
  /// When it is back at y = 0.
  double landing() const;
  Vec3d place(double time) const;
  Vec3d velocity(double time) const;
};

/// Moves one node along the flight, and has another, if there is one, flicker while it burns: before and after it is
/// a 64th of its size.
class RocketMotion final : public Controller {
 public:
  /// \throws std::invalid_argument for a flight that does not go up or come down.
  RocketMotion(const RocketFlight& flight, NodeId rocket, NodeId flame = no_node);
  void pose(double time, std::vector<NodePose>& poses) const override;

 private:
  RocketFlight flight_;
  NodeId rocket_, flame_;
};

}  // namespace sightline
