#include "labs/runner/grade_files.h"

#include <map>
#include <set>
#include <sstream>

#include "sightline/io/output_file.h"

namespace sightline::labs {
namespace {

using nlohmann::json;

std::size_t points_of(const json& lab) { return lab.at("passed").get<std::size_t>(); }
std::size_t most_of(const json& lab) { return lab.at("checks").size(); }
std::string text_of(const json& from, const char* name) { return from.value(name, std::string()); }

/// What XML and HTML read as markup, and what they may not hold.
std::string escaped(const std::string& text) {
  std::string safe;
  for (const char c : text) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += static_cast<unsigned char>(c) < 32 && c != '\n' && c != '\t' ? '?' : c;
    }
  }
  return safe;
}

/// A field of CSV. Spreadsheets run what begins like a formula: it begins with an apostrophe then.
std::string csv_field(const std::string& text) {
  std::string field = "\"";
  if (!text.empty() && std::string("=+-@\t\r").find(text[0]) != std::string::npos) field += '\'';
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + "\"";
}

/// What a student is told of a check.
std::string told(const json& lab, const json& check) {
  if (check.at("state") == "passed") return "passed";
  std::string text = text_of(check, "state") + "\ninput: " + text_of(check, "input") +
                     "\nexpected: " + text_of(check, "expected") + "\ngot: " + text_of(check, "got") +
                     "\nwhy: " + text_of(check, "why");
  return text + "\nagain: ./sightline lab replay " + text_of(lab, "lab").substr(0, 2) + " --case '" +
         text_of(check, "case") + "'";
}

json gradescope(const StudentGrades& grades) {
  json tests = json::array();
  double score = 0;
  for (const json& lab : grades.labs) {
    const std::string number = text_of(lab, "lab");
    if (!lab.at("built").get<bool>()) {
      tests.push_back({{"name", number},
                       {"score", 0},
                       {"max_score", 1},
                       {"status", "failed"},
                       {"output", text_of(lab, "state") + "\n" + text_of(lab, "messages")},
                       {"visibility", "visible"}});
    }
    for (const json& check : lab.at("checks")) {
      const bool is_passed = check.at("state") == "passed";
      score += is_passed;
      tests.push_back({{"name", number + ": " + text_of(check, "name")},
                       {"score", is_passed ? 1 : 0},
                       {"max_score", 1},
                       {"status", is_passed ? "passed" : "failed"},
                       {"output", told(lab, check)},
                       {"visibility", "visible"}});
    }
  }
  return {{"score", score}, {"output", summary_of(grades)}, {"tests", std::move(tests)}};
}

std::string junit(const std::vector<StudentGrades>& all) {
  std::ostringstream out;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
  for (const StudentGrades& grades : all) {
    for (const json& lab : grades.labs) {
      const bool is_built = lab.at("built").get<bool>();
      const std::size_t most = is_built ? most_of(lab) : 1, failures = most - points_of(lab);
      out << "  <testsuite name=\"" << escaped(grades.student + "/" + text_of(lab, "lab")) << "\" tests=\"" << most
          << "\" failures=\"" << failures << "\">\n";
      if (!is_built) {
        out << "    <testcase name=\"build\"><failure message=\"" << escaped(text_of(lab, "state")) << "\">"
            << escaped(text_of(lab, "messages")) << "</failure></testcase>\n";
      }
      for (const json& check : lab.at("checks")) {
        out << "    <testcase name=\"" << escaped(text_of(check, "name")) << "\"";
        if (check.at("state") == "passed") {
          out << "/>\n";
        } else {
          out << "><failure message=\"" << escaped(text_of(check, "got")) << "\">" << escaped(told(lab, check))
              << "</failure></testcase>\n";
        }
      }
      out << "  </testsuite>\n";
    }
  }
  out << "</testsuites>\n";
  return out.str();
}

/// Students down, labs across.
struct Matrix {
  std::set<std::string> labs;
  std::vector<std::map<std::string, const json*>> rows;

  explicit Matrix(const std::vector<StudentGrades>& all) {
    for (const StudentGrades& grades : all) {
      auto& row = rows.emplace_back();
      for (const json& lab : grades.labs) {
        labs.insert(text_of(lab, "lab"));
        row[text_of(lab, "lab")] = &lab;
      }
    }
  }
};

std::string class_csv(const std::vector<StudentGrades>& all) {
  const Matrix matrix(all);
  std::string text = "\"student\"";
  for (const std::string& lab : matrix.labs) text += "," + csv_field(lab) + "," + csv_field(lab + " of");
  text += "\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += csv_field(all[i].student);
    for (const std::string& lab : matrix.labs) {
      const auto found = matrix.rows[i].find(lab);
      text += found == matrix.rows[i].end()
                  ? ",,"
                  : "," + std::to_string(points_of(*found->second)) + "," + std::to_string(most_of(*found->second));
    }
    text += "\n";
  }
  return text;
}

/// A cell tells by words and by a sign, not by its color alone.
std::string html_cell(const json* lab) {
  if (lab == nullptr) return "<td class=none>&ndash;</td>";
  const std::size_t points = points_of(*lab), most = most_of(*lab);
  const bool is_whole = most > 0 && points == most, is_built = lab->at("built").get<bool>();
  std::string missing;
  for (const json& check : lab->at("checks")) {
    if (check.at("state") != "passed") missing += (missing.empty() ? "" : ", ") + text_of(check, "name");
  }
  const char* kind = is_whole ? "whole" : is_built ? "part" : "broken";
  const char* sign = is_whole ? "&#10003; " : is_built ? "" : "&#10007; ";
  return std::string("<td class=") + kind + " title=\"" +
         escaped(text_of(*lab, "state") + (missing.empty() ? "" : ": " + missing)) + "\">" + sign +
         (is_built ? std::to_string(points) + " / " + std::to_string(most) : escaped(text_of(*lab, "state"))) + "</td>";
}

std::string class_html(const std::vector<StudentGrades>& all, std::uint64_t seed) {
  const Matrix matrix(all);
  std::string text =
      "<!doctype html><html lang=en><meta charset=utf-8><title>Labs: the class</title>\n<style>"
      "body{font:16px system-ui,sans-serif;margin:2rem;color:#1f2430}table{border-collapse:collapse}"
      "th,td{padding:.35rem .8rem;border-bottom:1px solid #d5d8de;text-align:left}th{font-weight:600}"
      ".whole{background:#cfe5f5}.part{background:#fdf0cd}.broken{background:#f6d9c9}.none{color:#8a8f99}"
      "div{overflow-x:auto}</style>\n<h1>The class</h1>\n<p>Checks passed of all, a lab a column; point at a cell for "
      "what "
      "is missing. Cases were drawn with seed " +
      std::to_string(seed) + ".</p>\n<div><table>\n<tr><th>student</th>";
  for (const std::string& lab : matrix.labs) text += "<th>" + escaped(lab) + "</th>";
  text += "</tr>\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += "<tr><th>" + escaped(all[i].student) + "</th>";
    for (const std::string& lab : matrix.labs) {
      const auto found = matrix.rows[i].find(lab);
      text += html_cell(found == matrix.rows[i].end() ? nullptr : found->second);
    }
    text += "</tr>\n";
  }
  return text + "</table></div>\n</html>\n";
}

std::string report_text(const StudentGrades& grades) {
  std::string text = grades.student + "\n";
  for (const json& lab : grades.labs) {
    text += "\n" + text_of(lab, "lab") + ": " + text_of(lab, "state") + "\n";
    if (!lab.at("built").get<bool>()) text += text_of(lab, "messages") + "\n";
    for (const json& check : lab.at("checks")) text += "- " + text_of(check, "name") + ": " + told(lab, check) + "\n";
  }
  return text;
}

}  // namespace

std::string summary_of(const StudentGrades& grades) {
  std::string text;
  for (const json& lab : grades.labs) {
    text += (text.empty() ? "" : ", ") + text_of(lab, "lab").substr(0, 2) + ": ";
    const bool is_built = lab.at("built").get<bool>();
    text += is_built ? std::to_string(points_of(lab)) + " of " + std::to_string(most_of(lab)) : text_of(lab, "state");
  }
  return text.empty() ? "nothing handed in" : text;
}

void write_grades(const std::filesystem::path& folder, const std::vector<StudentGrades>& all, std::uint64_t seed) {
  const auto dumped = [](const json& value) {
    return value.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
  };
  for (const StudentGrades& grades : all) {
    write_text(folder / grades.student / "results.json", dumped(gradescope(grades)));
    write_text(folder / grades.student / "report.txt", report_text(grades));
  }
  write_text(folder / "junit.xml", junit(all));
  write_text(folder / "class.csv", class_csv(all));
  write_text(folder / "class.html", class_html(all, seed));
}

}  // namespace sightline::labs
