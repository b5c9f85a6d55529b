#pragma once
/// Grades in the formats that others read.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace sightline::labs {

struct StudentGrades {
  std::string student;
  std::vector<nlohmann::json> labs;  ///< json_of a report each (session.h).
};

/// "00: 7 of 7, 04: 3 of 9 (failing 6 of 9)".
std::string summary_of(const StudentGrades& grades);

/// STUDENT/results.json as Gradescope takes it, STUDENT/report.txt; junit.xml, class.csv, class.html of all.
void write_grades(const std::filesystem::path& folder, const std::vector<StudentGrades>& all, std::uint64_t seed);

}  // namespace sightline::labs
