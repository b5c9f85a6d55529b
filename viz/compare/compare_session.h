#pragma once
/// Structures over one scene, and what is found out about them as it is asked for.

#include <functional>

#include "viz/compare/compare_picture.h"

namespace sightline::viz {

class CompareSession {
 public:
  /// All have the same mesh. \throws std::invalid_argument where there are none
  CompareSession(std::vector<Compared> compared, CompareSource source);

  std::span<const Compared> compared() const { return compared_; }
  const CompareSource& source() const { return source_; }
  bool is_alone() const { return compared_.size() == 1; }

  /// The walks, and with `needs_pixels` all pixels of a panel, each `coarseness` pixels wide; `tell` hears of each
  /// structure before it is traced. What is known from the last time is not asked for again.
  const CompareFindings& find(const CompareLook& look, int width, int height, bool needs_pixels, int coarseness = 1,
                              const std::function<void(const std::string&)>& tell = {});
  /// Of the last findings; these and the session outlive it.
  ComparePicture picture(const CompareLook& look, int width, int height) const;

 private:
  std::vector<Compared> compared_;
  CompareSource source_;
  vtkSmartPointer<vtkPolyData> surface_;
  CompareFindings findings_;
};

}  // namespace sightline::viz
