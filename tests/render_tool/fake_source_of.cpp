/// What sightline-render is linked with to render noise instead, as slow as SIGHTLINE_FAKE_DELAY says, in microseconds
/// a sample. The scene is read, and then not looked at. SIGHTLINE_FAKE_STARTED names a file that appears with the first
/// sample.

#include <cstdlib>
#include <fstream>
#include <ostream>
#include <thread>

#include "tests/render/fake_source.h"
#include "viz/render_tool/source.h"

namespace sightline::render_tool {
namespace {

class SlowSource : public FakeSource {
 public:
  using FakeSource::FakeSource;
  Vec3d sample(int x, int y, std::uint32_t number) const override {
    if (delay_.count() > 0) std::this_thread::sleep_for(delay_);
    static const bool is_told = tell();
    if (!is_told) throw std::runtime_error("SIGHTLINE_FAKE_STARTED: cannot be written");
    if (std::getenv("SIGHTLINE_FAKE_FAILURE") && number == 2) throw std::runtime_error("the source has failed");
    return FakeSource::sample(x, y, number);
  }

 private:
  static bool tell() {
    const char* file = std::getenv("SIGHTLINE_FAKE_STARTED");
    return !file || static_cast<bool>(std::ofstream(file));
  }
  static std::chrono::microseconds delay() {
    const char* text = std::getenv("SIGHTLINE_FAKE_DELAY");
    return std::chrono::microseconds(text ? std::atoi(text) : 0);
  }
  std::chrono::microseconds delay_ = delay();
};

}  // namespace

std::unique_ptr<PictureSource> source_of(std::shared_ptr<const Scene>, const RenderSettings& settings) {
  auto source = std::make_unique<SlowSource>(settings.width, settings.height, settings.samples ? settings.samples : 4);
  source->seed = settings.seed;
  return source;
}

void print_plan(const PictureSource& source, std::ostream& out) { out << source.samples() << " samples of noise\n"; }

std::string bill_of(const PictureSource&, const RenderCounters& counters, double) {
  return "camera rays " + std::to_string(counters.camera_rays) + '\n';
}

}  // namespace sightline::render_tool
