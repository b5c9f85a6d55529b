#pragma once
/// Builders asked again: what was weighed at a node, evaluated outside of the library by the library's own functions.

#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/accel/primitives.h"
#include "sightline/query/tracer.h"
#include "viz/build/decision.h"

namespace sightline::viz {

/// The replay came to something else than the library: a fault of one of them, never of the input.
class ReplayError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Of one structure over one scene. What leads to a node is kept, so that its neighbours come quickly.
class BuildReplay {
 public:
  virtual ~BuildReplay() = default;

  /// The decision at the node to which these children lead from the root: 0 for the first, 1 for the second.
  /// \throws std::out_of_range where the way ends in a leaf before, ReplayError
  virtual Decision decide(std::span<const int> way) = 0;
};

/// Which structures can be asked, in the order of the registry.
std::span<const std::string_view> replayed_structures();

/// \throws std::invalid_argument for a structure that cannot be asked, or a bad option. Refers to the primitives.
std::unique_ptr<BuildReplay> make_replay(const std::string& accelerator, const Primitives& primitives,
                                         const TracerSettings& settings);

/// The same for one structure each.
std::unique_ptr<BuildReplay> make_kd_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_box_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_sphere_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_cylinder_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_bih_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_bsp_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_wide_replay(const Primitives& primitives, const TracerSettings& settings);
std::unique_ptr<BuildReplay> make_grid_replay(const Primitives& primitives, const TracerSettings& settings);

/// States along the way from the root: those that the last way shares with this one are kept.
template <class State>
class WayStates {
 public:
  /// `divide(state, turn, depth)` makes the child's state.
  template <class MakeRoot, class Divide>
  State& at(std::span<const int> way, MakeRoot&& make_root, Divide&& divide) {
    if (states_.empty()) states_.push_back(make_root());
    std::size_t shared = 0;
    while (shared < way.size() && shared < way_.size() && way[shared] == way_[shared]) ++shared;
    states_.resize(shared + 1);
    way_.assign(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(shared));
    for (std::size_t depth = shared; depth < way.size(); ++depth) {
      State child = divide(states_.back(), way[depth], static_cast<int>(depth));
      states_.push_back(std::move(child));
      way_.push_back(way[depth]);
    }
    return states_.back();
  }

 private:
  std::vector<State> states_;
  std::vector<int> way_;
};

/// "1.25", "9,880": as few digits as tell costs apart for a person.
std::string cost_text(double value);
/// "x = 1.25".
std::string place_text(int axis, double position);

}  // namespace sightline::viz
