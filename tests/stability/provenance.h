#pragma once
/// With what a report was made; another processor or compiler may round otherwise.

#include <string>

namespace sightline::stability {

struct Provenance {
  std::string version;  ///< Of Sightline.
  std::string date;
  std::string processor;
  unsigned hardware_threads = 0;
  std::string system;
  std::string compiler;
  std::string flags;
  std::string build_type;
  bool has_assertions = false;
};
Provenance provenance();

}  // namespace sightline::stability
