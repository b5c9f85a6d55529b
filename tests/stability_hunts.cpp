#include "tests/stability_hunts.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <nlohmann/json.hpp>
#include <span>

#include "sightline/io/output_file.h"
#include "tests/hard_cases/families_report.h"
#include "tests/hard_cases/leaks/leak_report.h"
#include "viz/run_tool.h"

namespace sightline {
namespace {

constexpr const char* about =
    R"(Families: questions that get harder by a number k, asked at every level and through every structure, against a truth
that shares no code with the library; and of code as it is often written, to show that they are hard. Prints how many
answers are wrong at each k.

Leaks: rays at edges and vertices of closed meshes, from inside and from outside, each of which is known to hit. Prints
how many went through, and of each structure the first one as a line by which it can be asked again.)";

constexpr const char* examples = R"(
Examples
  sightline-stability --families
  sightline-stability --family grazing --questions 1000 --charts out/stability
  sightline-stability --leaks 100M --accel wide-tree
  sightline-stability --leaks 1M --leaks-level fast

Exit status: 0 all is as it was promised, 1 an answer above fast is wrong, or a ray leaks, or a file could not be
written, 2 wrong usage.
)";

struct Request {
  bool has_families = false;
  std::vector<std::string> families, structures, settings;
  std::string leaks, leaks_level = "watertight", charts, json;
  std::uint64_t questions = 40, seed = 1;
  int threads = 0;
};

void add_options(CLI::App& app, Request& request) {
  app.add_flag("--families", request.has_families, "Asks all families of questions");
  app.add_option("--family", request.families, "Only these families; by commas or repeated")
      ->option_text("NAME")
      ->delimiter(',');
  app.add_option("--questions", request.questions, "At each difficulty; default 40")
      ->option_text("N")
      ->check(CLI::Range(1, 1'000'000));
  app.add_option("--charts", request.charts, "Draws each family's failures: DIR/NAME.svg")->option_text("DIR");
  app.add_option("--leaks", request.leaks, "Hunts leaks by so many rays in all, such as 1M")->option_text("COUNT");
  app.add_option("--leaks-level", request.leaks_level, "Of rays of float: watertight (default) or fast")
      ->option_text("LEVEL");
  app.add_option("--accel", request.structures, "Structures to hunt leaks through; default all")
      ->option_text("NAME[:OPTION=VALUE,...]");
  app.add_option("--threads", request.threads, "To hunt leaks with; default as many as there are")
      ->check(CLI::Range(0, 4096));
  app.add_option("--seed", request.seed, "Other questions, other rays; default 1");
  app.add_option("--json", request.json, "Writes all that was found")->option_text("FILE");
}

/// "1500", "10k", "100M" or "2G".
std::uint64_t count_of(const std::string& text) {
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const std::uint64_t factor = unit.empty() ? 1 : unit == "k" ? 1'000 : unit == "M" ? 1'000'000 : 1'000'000'000;
  const bool is_known = unit.empty() || unit == "k" || unit == "M" || unit == "G";
  if (error != std::errc() || !is_known || count == 0 || count > 1'000'000'000'000 / factor) {
    throw std::invalid_argument("--leaks: expected a number from 1 to 1000G, with k, M or G behind it or not, found '" +
                                text + "'");
  }
  return count * factor;
}

Level leaks_level_of(const std::string& name) {
  for (const Level level : triangle_levels) {
    if (info_of(level).name == name) return level;
  }
  throw std::invalid_argument("--leaks-level: expected watertight or fast, found '" + name + "'");
}

std::vector<const hard::Family*> families_of(const std::vector<std::string>& names) {
  std::vector<const hard::Family*> chosen;
  for (const std::string& name : names) {
    const hard::Family* family = hard::family_named(name);
    if (!family) {
      std::string known;
      for (const hard::Family& one : hard::families()) known += " " + std::string(one.name);
      throw std::invalid_argument("--family: expected one of" + known + ", found '" + name + "'");
    }
    chosen.push_back(family);
  }
  if (names.empty()) {
    for (const hard::Family& family : hard::families()) chosen.push_back(&family);
  }
  return chosen;
}

hard::LeakPlan plan_of(const Request& request, const std::filesystem::path& data_dir) {
  hard::LeakPlan plan;
  plan.rays = count_of(request.leaks);
  plan.level = leaks_level_of(request.leaks_level);
  plan.seed = request.seed;
  plan.threads = request.threads;
  plan.data_dir = data_dir;
  for (const std::string& text : request.structures) {
    for (AcceleratorSpec& spec : parse_accelerators(text)) plan.structures.push_back(std::move(spec));
  }
  return plan;
}

bool ask_families(const Request& request, nlohmann::json& json, std::ostream& out, std::ostream& messages) {
  bool keeps_promises = true;
  Progress progress;
  for (const hard::Family* family : families_of(request.families)) {
    const auto tell = [&](double share) { progress.say("asking families", std::string(family->name), share); };
    const hard::FamilyResult result = hard::run_family(*family, request.questions, request.seed, tell);
    progress.clear();
    out << text_table(result) << '\n' << std::flush;
    keeps_promises = keeps_promises && result.keeps_promises();
    json["families"].push_back(to_json(result));
    if (request.charts.empty()) continue;
    const std::filesystem::path file = std::filesystem::path(request.charts) / (result.name + ".svg");
    write_text(file, failure_chart_svg(result));
    messages << "sightline-stability: wrote " << file.string() << '\n';
  }
  return keeps_promises;
}

}  // namespace

bool asks_hunts(int argc, const char* const* argv) {
  for (const std::string_view word : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    if (word == "--families" || word == "--family" || word.starts_with("--family=") || word == "--leaks" ||
        word.starts_with("--leaks=")) {
      return true;
    }
  }
  return false;
}

int run_hunts(int argc, const char* const* argv, const std::filesystem::path& data_dir, std::ostream& out,
              std::ostream& messages) {
  CLI::App app(about, "sightline-stability");
  app.footer(examples);
  Request request;
  add_options(app, request);
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;
  const bool asks_families = request.has_families || !request.families.empty();
  const std::optional<hard::LeakPlan> plan =
      request.leaks.empty() ? std::nullopt : std::optional(plan_of(request, data_dir));
  families_of(request.families);  // refuses unknown names before anything is asked
  nlohmann::json json;
  bool is_fine = !asks_families || ask_families(request, json, out, messages);
  if (plan) {
    Progress progress;
    const hard::LeakReport report = hunt_leaks(*plan, progress);
    out << text_table(report) << std::flush;
    json["leaks"] = to_json(report);
    is_fine = is_fine && report.leaks() == 0;
  }
  if (!request.json.empty()) {
    write_text(request.json, json.dump(1) + "\n");
    messages << "sightline-stability: wrote " << request.json << '\n';
  }
  return is_fine ? success : failure;
}

}  // namespace sightline
