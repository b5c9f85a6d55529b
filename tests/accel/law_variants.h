#pragma once

#include <utility>

#include "sightline/accel/options.h"
#include "sightline/accel/primitives.h"

namespace sightline::laws {

/// A structure as the laws build it, with options that change(options) has set, once those that it was given are valid.
template <class Structure, auto change>
class Changed : public Structure {
 public:
  using Options = typename Structure::Options;

  static Changed build(const Primitives& primitives, Options options) {
    validate(Structure::name, options);
    change(options);
    return Changed(Structure::build(primitives, options));
  }

 private:
  explicit Changed(Structure&& structure) : Structure(std::move(structure)) {}
};

}  // namespace sightline::laws
