#pragma once
/// What has been found out about structures, and whether they agree.

#include "viz/compare/comparison.h"

namespace sightline::viz {

struct CompareFindings {
  std::vector<Walk> walks;            ///< One a structure.
  std::vector<TracedPicture> traced;  ///< The same, or none where nothing shows them.
  Camera camera;                      ///< Of `traced`.
  int pixel_size = 1;                 ///< Of a traced pixel, in pixels of the picture.
};

/// The hits of walks and pixels, bit for bit: a line that says that all are the same, or which are not.
struct Verdict {
  bool is_same = true;
  std::string text;
};
Verdict verdict_of(std::span<const Compared> compared, const CompareFindings& findings);

/// "1 leaf", "1,234 leaves".
std::string counted(std::uint64_t count, const std::string& one, const std::string& more);

}  // namespace sightline::viz
