#pragma once
/// What is traded for time: an axis is one question ("how is a triangle tested?"), its panels are the conditions under
/// which it is asked, and a panel's choices are the answers, each with its error and its price.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sightline::bench {

inline constexpr double not_asked = std::numeric_limits<double>::quiet_NaN();

/// Against the oracle, outside of all timing. NaN where a number makes no sense of a choice.
struct Errors {
  double maximum = not_asked;
  double rms = not_asked;
  double wrong_per_million = not_asked;  ///< Decisions that differ from exact ones.
  std::size_t wrong = 0, decisions = 0;  ///< The same as counts, where it is a share of so many.
};

/// By which of the errors a panel's front is drawn.
enum class ErrorKind { maximum, rms, wrong };

inline double error_of(const Errors& errors, ErrorKind kind) {
  return kind == ErrorKind::maximum ? errors.maximum : kind == ErrorKind::rms ? errors.rms : errors.wrong_per_million;
}

struct Choice {
  std::string name;
  Errors errors;
  std::function<double()> pass;  ///< What is timed: all units once. Its result depends on all of them.
  std::vector<std::pair<std::string, double>> extras{};  ///< What else is worth knowing: "false hits", "bytes", ...
};

struct Panel {
  std::string name;
  std::string description;
  std::string unit;        ///< Of which the nanoseconds are: "test", "ray", ...
  std::string error_unit;  ///< In which maximum and RMS are.
  ErrorKind kind = ErrorKind::maximum;
  double units = 1;  ///< In a pass.
  std::vector<Choice> choices{};
  std::string wrong_name = "wrong decisions";  ///< What of a million is told.
};

/// How much may be spent.
struct Effort {
  bool is_quick = false;
  std::uint64_t seed = 1;
  std::string data_dir{};
  std::function<void(const std::string&)> tell{};  ///< Of what is under way.
  int rounds = 9;                                  ///< Of timing, for those who time themselves.
  double share = 1;                                ///< Of all counts: a small one says nothing, but soon.

  std::size_t count(std::size_t full, std::size_t quick) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(share * static_cast<double>(is_quick ? quick : full)));
  }
  void say(const std::string& what) const {
    if (tell) tell(what);
  }
};

struct Axis {
  std::string_view name;
  std::string_view question;
  std::vector<Panel> (*panels)(const Effort& effort);
};

}  // namespace sightline::bench
