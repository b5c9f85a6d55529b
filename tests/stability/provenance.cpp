#include "tests/stability/provenance.h"

#include <thread>

#include "sightline/io/host.h"

namespace sightline::stability {

Provenance provenance() {
  Provenance own;
  own.version = SIGHTLINE_STABILITY_VERSION;
  own.date = utc_date();
  own.processor = processor_name();
  own.hardware_threads = std::thread::hardware_concurrency();
  own.system = system_name();
  own.compiler = compiler_name();
  own.flags = SIGHTLINE_STABILITY_FLAGS;
  own.build_type = SIGHTLINE_STABILITY_BUILD_TYPE;
#ifndef NDEBUG
  own.has_assertions = true;
#endif
  return own;
}

}  // namespace sightline::stability
