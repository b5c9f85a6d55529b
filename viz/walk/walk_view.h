#pragma once
/// The picture of one step of a walk, in a window that is there already.

#include "viz/walk/walk_panels.h"
#include "viz/walk/walk_space.h"

namespace sightline::viz {

struct WalkLook {
  double azimuth = 24, elevation = 20, zoom = 1;
  int width = 1920, height = 1080;

  WalkLayout layout() const { return {width, height}; }
  SpaceCamera camera(const WalkModel& model) const;
};

/// The command line that gives a picture.
std::string command_of(const WalkModel& model, std::size_t step, const WalkLook& look);

/// Through the middle of a pixel of the picture, from before the mesh; nothing beside the view of space.
std::optional<Ray<float>> ray_through_pixel(const WalkModel& model, const WalkLook& look, int x, int y);
/// How far the view turns when a ray is chosen by a pixel: it would be seen end on.
inline constexpr double aside = 40;

class WalkView {
 public:
  /// `whole` triangles are drawn as those of `coarse`.
  WalkView(vtkRenderWindow& window, const TriangleMesh& coarse, std::size_t whole, double scale);

  void show(const WalkModel& model, std::size_t step, const WalkLook& look);
  /// The same from elsewhere: what is flat stays.
  void turn(const WalkModel& model, std::size_t step, const WalkLook& look);

 private:
  double scale_;
  std::string drawn_;
  vtkSmartPointer<vtkRenderer> flat_, labels_;
  WalkSpace space_;
};

}  // namespace sightline::viz
