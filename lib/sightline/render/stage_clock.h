#pragma once

#include <array>
#include <chrono>

#include "sightline/render/effect.h"

namespace sightline {

/// What the time of a picture goes to: tracing rays of an effect, or evaluating it.
struct StageTimes {
  using Clock = std::chrono::steady_clock;

  std::array<Clock::duration, effect_count> of_effects{};
  Clock::duration camera{};   ///< Rays from the camera.
  Clock::duration shading{};  ///< Surfaces, but for the effects that are timed by themselves.

  Clock::duration total() const {
    Clock::duration sum = camera + shading;
    for (const Clock::duration part : of_effects) sum += part;
    return sum;
  }
  StageTimes& operator+=(const StageTimes& others) {
    for (std::size_t i = 0; i < effect_count; ++i) of_effects[i] += others.of_effects[i];
    camera += others.camera;
    shading += others.shading;
    return *this;
  }
};

/// Adds the time until it ends to a part of StageTimes, and takes it from the part that is timed around it. Without a
/// part it does nothing, and costs a comparison.
class StageClock {
 public:
  using Duration = StageTimes::Clock::duration;

  static Duration* camera(StageTimes* times) { return times ? &times->camera : nullptr; }
  static Duration* shading(StageTimes* times) { return times ? &times->shading : nullptr; }
  static Duration* of(StageTimes* times, Effect effect) {
    return times ? &times->of_effects[index_of(effect)] : nullptr;
  }

  explicit StageClock(Duration* part, Duration* around = nullptr) : part_(part), around_(around) {
    if (part_) start_ = StageTimes::Clock::now();
  }
  ~StageClock() {
    if (!part_) return;
    const Duration passed = StageTimes::Clock::now() - start_;
    *part_ += passed;
    if (around_) *around_ -= passed;
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

 private:
  Duration* part_;
  Duration* around_;
  StageTimes::Clock::time_point start_;
};

}  // namespace sightline
