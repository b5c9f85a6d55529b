#include "labs/runner/tell.h"

#include <ostream>

namespace sightline::labs {
namespace {

constexpr const char* good = "32";
constexpr const char* bad = "31;1";
constexpr const char* soft = "2";
constexpr const char* strong = "1";
/// The width that terminals have.
constexpr std::size_t width = 100, indent = 14;

/// Words on lines that are no longer than `width`, all but the first with `indent` blanks.
std::string wrapped(const std::string& text) {
  std::string lines;
  std::size_t column = indent, at = 0;
  while (at < text.size()) {
    std::size_t end = text.find_first_of(" \n", at);
    if (end == std::string::npos) end = text.size();
    if (column > indent && column + (end - at) > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    }
    lines += text.substr(at, end - at);
    column += end - at;
    if (end < text.size() && text[end] == '\n') {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (end < text.size()) {
      lines += ' ';
      ++column;
    }
    at = end + 1;
  }
  return lines;
}

}  // namespace

std::filesystem::path picture_of(const Workshop& workshop, const Lab& lab, const Outcome& outcome) {
  return workshop.work_of(lab) / "pictures" / (outcome.check->name + ".png");
}

std::string Teller::painted(const char* code, const std::string& text) const {
  return has_colors_ ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
}

void Teller::line(const std::string& name, const std::string& text) const {
  if (text.empty()) return;
  out_ << "    " << painted(soft, name) << std::string(indent - 4 - name.size(), ' ') << wrapped(text) << '\n';
}

void Teller::tell(const Workshop& workshop, const Lab& lab, const Outcome& outcome) const {
  const Check& check = *outcome.check;
  if (outcome.state == Outcome::State::hole) {
    out_ << "  " << painted(soft, "·") << ' ' << check.name << ": " << outcome.trouble.got << '\n';
    return;
  }
  if (outcome.state == Outcome::State::passed) {
    out_ << "  " << painted(good, "✓") << ' ' << check.name;
    if (outcome.cases > 1) out_ << painted(soft, "  " + std::to_string(outcome.cases) + " cases");
    out_ << '\n';
    return;
  }
  out_ << "  " << painted(bad, "✗ " + check.name) << painted(soft, "  (handout, " + check.section + ")") << '\n';
  if (check.describe) line("input", check.describe(outcome.at));
  line("expected", outcome.trouble.expected);
  line("got", outcome.trouble.got);
  line("why", check.why);
  line("printed", outcome.printed);
  line("hint", "./sightline lab hint " + lab.number);
  if (const auto picture = picture_of(workshop, lab, outcome); std::filesystem::exists(picture)) {
    line("picture", Workshop::shown(picture));
  }
  // In one line, however long: it is there to be copied.
  out_ << "    " << painted(soft, "again") << std::string(indent - 9, ' ') << "./sightline lab replay " << lab.number
       << " --case '" << outcome.id() << "'\n";
}

void Teller::tell(const Workshop& workshop, const Report& report) const {
  const Lab& lab = *report.lab;
  out_ << painted(strong, "Lab " + lab.number + ", " + lab.title) << '\n';
  if (!report.is_built) {
    out_ << report.messages << "  " << painted(bad, "does not build")
         << ": the compiler's first error is the one to mend\n";
    return;
  }
  for (const Outcome& outcome : report.outcomes) tell(workshop, lab, outcome);
  out_ << "  " << painted(report.is_right() ? good : strong, state_of(report)) << '\n';
}

}  // namespace sightline::labs
