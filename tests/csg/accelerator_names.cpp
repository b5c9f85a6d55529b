#include "sightline/accel/registry.h"
#include "tests/csg/evaluate.h"

namespace sightline {

std::vector<std::string_view> accelerator_names() {
  std::vector<std::string_view> names;
  Accelerators::for_each([&]<class Structure>(auto) { names.push_back(Structure::name); });
  return names;
}

}  // namespace sightline
