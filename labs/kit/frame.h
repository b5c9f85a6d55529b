#pragma once
/// Messages through a pipe: a length, then as many bytes.

#include <cstdint>

namespace sightline::labs {

/// The descriptors through which a student's program is asked: its own standard streams remain the student's.
inline constexpr int questions_descriptor = 3, answers_descriptor = 4;

/// No message is longer.
inline constexpr std::uint64_t longest_message = std::uint64_t{1} << 30;

}  // namespace sightline::labs
