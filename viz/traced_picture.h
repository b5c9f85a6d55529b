#pragma once

#include <cstdint>
#include <vector>

#include "sightline/io/image_file.h"
#include "sightline/query/tracer.h"
#include "sightline/scene/camera.h"

namespace sightline::viz {

/// What one structure answers for the rays of a picture, pixel by pixel from the top.
struct TracedPicture {
  std::vector<Hit<float>> hits;
  std::vector<std::uint32_t> work;        ///< Nodes, leaves and candidates examined.
  std::vector<std::uint32_t> candidates;  ///< Those alone.
};

/// Closest hits of all rays, on all cores. The answer does not depend on how rows are shared out.
TracedPicture trace_picture(const Tracer& tracer, const Camera& camera);

/// Clay under a soft sky: shaded from hits alone, so that equal hits give equal pictures.
Image shaded_picture(const TriangleMesh& mesh, const Camera& camera, const std::vector<Hit<float>>& hits);

/// How many pixels of `hits` a fresh trace contradicts, looking at every `stride`-th pixel across and down.
struct Agreement {
  std::size_t compared = 0;
  std::size_t differing = 0;
};
Agreement compare_with(const Tracer& oracle, const Camera& camera, const std::vector<Hit<float>>& hits, int stride);

}  // namespace sightline::viz
