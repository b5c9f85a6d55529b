#pragma once
/// What a student reads in the terminal.

#include <iosfwd>

#include "labs/runner/session.h"

namespace sightline::labs {

/// Colors and marks where the stream is a terminal, plain words elsewhere.
class Teller {
 public:
  explicit Teller(std::ostream& out, bool has_colors) : out_(out), has_colors_(has_colors) {}

  /// A line a check; of the first that fails everything, of others what they expect; holes last.
  void tell(const Workshop& workshop, const Report& report) const;
  /// Input, expected, got, why it matters, where to read on, the picture where there is one, the line that asks again.
  void tell(const Workshop& workshop, const Lab& lab, const Outcome& outcome) const;

 private:
  std::string painted(const char* code, const std::string& text) const;
  void line(const std::string& name, const std::string& text) const;

  std::ostream& out_;
  bool has_colors_;
};

/// Where the picture of a failure goes.
std::filesystem::path picture_of(const Workshop& workshop, const Lab& lab, const Outcome& outcome);

}  // namespace sightline::labs
