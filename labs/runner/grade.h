#pragma once
/// Many submissions graded: what each check says of each, in the formats that graders and build servers read.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "labs/runner/workshop.h"

namespace sightline::labs {

struct GradeRequest {
  std::vector<std::filesystem::path>
      submissions;                ///< A folder or an archive of `submit` each; its name is the student's.
  std::vector<std::string> labs;  ///< All that are there, where empty.
  std::filesystem::path out = "grades";
  std::uint64_t seed = 0;   ///< Cases that students cannot know beforehand.
  int threads = 1;          ///< Submissions at a time.
  bool is_trusted = false;  ///< Without a sandbox.
};

/// Writes STUDENT/results.json (Gradescope), STUDENT/report.txt, junit.xml, class.csv and class.html. 0 where every
/// submission was graded, whatever it came to.
int grade(const Workshop& workshop, const GradeRequest& request);

}  // namespace sightline::labs
