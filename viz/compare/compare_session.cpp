#include "viz/compare/compare_session.h"

#include <stdexcept>

namespace sightline::viz {
namespace {

constexpr int alone_coarseness =
    2;  // so that the others, whose scale it shares, need not be traced four times as finely

bool is_same_camera(const Camera& a, const Camera& b) {
  return a.eye == b.eye && a.forward == b.forward && a.right == b.right && a.up == b.up && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

CompareSession::CompareSession(std::vector<Compared> compared, CompareSource source)
    : compared_(std::move(compared)), source_(std::move(source)) {
  if (compared_.empty()) throw std::invalid_argument("nothing to compare");
  surface_ = smooth_surface(compared_.front().tracer->mesh());
}

const CompareFindings& CompareSession::find(const CompareLook& look, int width, int height, bool needs_pixels,
                                            int coarseness, const std::function<void(const std::string&)>& tell) {
  const bool has_ray = !findings_.walks.empty() && findings_.walks.front().ray.origin == look.ray.origin &&
                       findings_.walks.front().ray.direction == look.ray.direction;
  if (!has_ray) findings_.walks = walks_of(compared_, look.ray);
  if (!needs_pixels) {
    findings_.traced.clear();
    return findings_;
  }
  const ComparePicture picture = this->picture(look, width, height);
  const PixelFrame frame = picture.layout().pictures().front();
  const int pixel_size = std::max(coarseness, look.alone ? alone_coarseness : 1);
  Camera camera = tracing_camera(picture.camera(), frame.width / pixel_size, frame.height / pixel_size);
  if (!findings_.traced.empty() && is_same_camera(camera, findings_.camera)) return findings_;
  findings_.traced.clear();
  for (const Compared& each : compared_) {
    if (tell) tell(each.label);
    findings_.traced.push_back(trace_grown(*each.tracer, camera));
  }
  findings_.camera = camera;
  findings_.pixel_size = pixel_size;
  return findings_;
}

ComparePicture CompareSession::picture(const CompareLook& look, int width, int height) const {
  return {compared_, surface_, findings_, look, source_, width, height};
}

}  // namespace sightline::viz
