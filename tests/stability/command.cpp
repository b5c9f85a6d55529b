#include "tests/stability/command.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "sightline/io/output_file.h"
#include "tests/stability/json.h"
#include "tests/stability/names.h"
#include "tests/stability/page.h"
#include "tests/stability/print.h"
#include "tests/stability/sketch_svg.h"
#include "tests/stability/text.h"
#include "viz/run_tool.h"

namespace sightline::stability {
namespace {

constexpr const char* about =
    R"(Asks the library questions at which ray tracing code is known to fail, at every level of precision, and compares the
answers with a truth that shares no code with it: rationals, Sturm chains, more digits, closed forms, brute force.

Prints a line a case:
  exact        the true decision, and every number the true one, rounded to nearest
  bound        the true decision, and numbers as near the true ones as that level promises
  WRONG 3/200  anything else, with how many of how many; only fast, float throughout, promises nothing here
  –            the column does not apply; always is what has no levels
  naive        how often code as it is often written is wrong of the same questions
and after the columns, whether the case is a policy (more than one answer is right, and ours is always the same), and
which structures or routines are worse than the rest of the line.)";

constexpr const char* examples = R"(
Examples
  sightline-stability --quick
  sightline-stability --case 'sph-*,tri-edge' --level watertight
  sightline-stability --explain sph-far
  sightline-stability --quick --html --json out/stability.json
  sightline-stability --families --help
  sightline-stability --leaks 10M

Exit status: 0 all promises were kept, 1 WRONG stands at watertight, precise, exact or always, a case failed, or a file
could not be written, 2 wrong usage.
)";

struct Request {
  std::vector<std::string> cases, groups, structures;
  std::string level, explain, out, json, html;
  bool is_list = false, is_quick = false, has_html = false;
};

CLI::Option* add_options(CLI::App& app, Request& request) {
  app.add_option("--case", request.cases, "Only these cases: ids, also as patterns; by commas or repeated")
      ->option_text("ID");
  app.add_option("--group", request.groups, "Only cases of these groups, such as sphere; by commas or repeated")
      ->option_text("GROUP");
  app.add_option("--level", request.level, "Only answers at this level: fast, watertight, precise or exact")
      ->option_text("LEVEL");
  app.add_option("--accel", request.structures, "Only answers of these structures; by commas or repeated")
      ->option_text("NAME");
  app.add_flag("--quick", request.is_quick, "A tenth of the questions");
  app.add_flag("--list", request.is_list, "What cases there are, without asking");
  app.add_option("--explain", request.explain,
                 "All about one case: why it is hard, what was asked, answered and true, drawn")
      ->option_text("ID");
  app.add_option("--out", request.out, "Where its drawing goes, an SVG and nothing else; default out/stability/ID.svg")
      ->option_text("FILE.svg");
  app.add_option("--json", request.json, "Writes all that was found")->option_text("FILE");
  return app.add_option("--html", request.html, "Writes a page to explore it; default out/stability/index.html")
      ->option_text("[FILE]")
      ->expected(0, 1);
}

void check_uses(const Request& request) {
  const auto refuse = [](const std::string& name, const std::string& other) {
    throw std::invalid_argument(name + ": expected without " + other + ", found both");
  };
  const bool has_files = !request.json.empty() || request.has_html;
  if (!request.out.empty() && request.explain.empty()) {
    throw std::invalid_argument("--out: expected with --explain, found without");
  }
  if (!request.out.empty() && !request.out.ends_with(".svg")) {
    throw std::invalid_argument("--out: expected a name that ends in .svg, found '" + request.out + "'");
  }
  if (request.is_list && (has_files || !request.explain.empty())) refuse("--list", "--explain, --json and --html");
  if (!request.explain.empty() && has_files) refuse("--explain", "--json and --html");
  if (!request.explain.empty() && !(request.cases.empty() && request.groups.empty())) {
    refuse("--explain", "--case and --group");
  }
}

/// Finds out before minutes of asking what cannot be written. Leaves nothing.
void check_writable(const std::string& file) {
  if (!file.empty()) const OutputFile probe(file);
}

std::string drawing_of(const HardCase& one, const Request& request) {
  return request.out.empty() ? "out/stability/" + std::string(one.id) + ".svg" : request.out;
}

int explain(const Report& report, const Request& request, std::ostream& out) {
  const CaseReport& one = report.cases.front();
  const std::string id(one.hard_case->id);
  print_explanation(out, one, "./sightline stability --explain " + id + (request.is_quick ? " --quick" : ""));
  const std::string file = drawing_of(*one.hard_case, request);
  write_text(file, svg_of(one.hard_case->draw()));
  out << "drawing     " << file << '\n' << std::flush;
  return keeps_promises(one) ? success : failure;
}

int show_all(const Report& report, const Request& request, const std::optional<Level>& level, std::ostream& out,
             std::ostream& messages) {
  print_matrix(out, report, level);
  out.flush();
  const auto write = [&](const std::string& file, const std::string& text) {
    write_text(file, text);
    messages << "sightline-stability: wrote " << file << '\n';
  };
  if (!request.json.empty()) write(request.json, json_text(report, provenance()));
  if (request.has_html) write(request.html, page_of(report, provenance()));
  return keeps_promises(report) ? success : failure;
}

}  // namespace

int run(std::span<const HardCase> cases, int argc, const char* const* argv, std::ostream& out, std::ostream& messages) {
  CLI::App app(about, "sightline-stability");
  app.footer(examples);
  Request request;
  const CLI::Option* html = add_options(app, request);
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;
  request.has_html = html->count() > 0;
  if (request.html.empty()) request.html = "out/stability/index.html";
  check_uses(request);
  Limits limits;
  if (!request.level.empty()) limits.level = level_named(request.level);
  limits.structures = split_at_commas(request.structures);
  check_structures(limits.structures);
  const std::vector<std::string> ids =
      request.explain.empty() ? split_at_commas(request.cases) : std::vector{request.explain};
  const std::vector<const HardCase*> selected = select(cases, ids, split_at_commas(request.groups));
  if (!request.explain.empty() && selected.size() != 1) {
    throw std::invalid_argument("--explain: expected one case, found " + std::to_string(selected.size()));
  }
  if (request.is_list) {
    print_list(out, selected);
    return success;
  }
  check_writable(request.json);
  check_writable(request.has_html ? request.html : "");
  check_writable(request.explain.empty() ? "" : drawing_of(*selected.front(), request));
  Progress progress;
  Report report = ask(selected, request.is_quick ? 0.1 : 1, progress);
  limit(report, limits);
  if (report.cases.empty()) throw std::invalid_argument("no case is left by --case, --group, --level and --accel");
  return request.explain.empty() ? show_all(report, request, limits.level, out, messages)
                                 : explain(report, request, out);
}

}  // namespace sightline::stability
