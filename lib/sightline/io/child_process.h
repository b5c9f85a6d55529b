#pragma once
/// Work that may crash, hang or eat the memory, in a process of its own.

#include <chrono>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace sightline {

struct ChildLimits {
  std::chrono::seconds time{20};                  ///< By the clock.
  std::uint64_t memory = std::uint64_t{2} << 30;  ///< Bytes that it has beyond its parent's, and that it answers.
};

/// The work ended otherwise than by an answer; what() tells how, such as "a crash (signal 11)".
class ChildFailure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What work() returns, run in a fork of this process, whose standard streams lead nowhere. It is killed where it goes
/// beyond the limits (memory is looked at every few milliseconds) or where its parent ends.
///   C1  The work must not wait for other threads, which a fork does not have, nor start some.
/// \throws ChildFailure where work() throws, with its what(), and where it crashes or is killed.
std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits = {});

}  // namespace sightline
