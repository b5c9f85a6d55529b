#include "bench/render/instructions.h"

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/json.h"
#include "bench/render/pictures.h"
#include "bench/run_program.h"
#include "bench/solids/scratch_folder.h"
#include "bench/subcommand.h"
#include "bench/text_table.h"

namespace sightline::bench {
namespace {

#ifdef __AVX512F__
constexpr bool has_avx512 = true;
#else
constexpr bool has_avx512 = false;
#endif

/// Runs callgrind on one line of a picture.
class Callgrind {
 public:
  explicit Callgrind(const RenderPlanOfBench& plan) : plan_(plan) {
    if (has_avx512) {
      throw std::runtime_error(
          "this build has AVX-512 instructions, which valgrind does not know: configure another with "
          "-DSIGHTLINE_NATIVE=OFF (bench/README.md)");
    }
    if (run_program({"valgrind", "--version"}, log_) == no_such_program)
      throw std::runtime_error("expected valgrind on the PATH, found none: apt-get install valgrind");
  }

  std::size_t count(const std::string& picture, std::string_view line) const {
    const std::string own = std::filesystem::read_symlink("/proc/self/exe").string();
    std::vector<std::string> words{"valgrind",
                                   "--tool=callgrind",
                                   "--callgrind-out-file=" + counts_.string(),
                                   "--toggle-collect=sightline::bench::paint_once*",
                                   own,
                                   "render",
                                   "--scene",
                                   picture,
                                   "--only",
                                   std::string(line),
                                   "--precision",
                                   std::string(info_of(plan_.level).name),
                                   "--textures",
                                   plan_.filters_textures ? "filtered" : "point"};
    if (plan_.is_quick) words.emplace_back("--quick");
    const int code = run_program(words, log_);
    if (code == 0) return total_of(text_in(counts_));
    const std::string log = text_in(log_);
    const std::size_t sign = log.find("unhandled instruction");
    throw std::runtime_error("valgrind failed with exit code " + std::to_string(code) +
                             (sign == std::string::npos ? "" : ": it met an instruction that it does not know"));
  }

 private:
  const RenderPlanOfBench& plan_;
  ScratchFolder folder_{{"counts", "log"}};
  std::filesystem::path counts_ = folder_.path() / "counts", log_ = folder_.path() / "log";
};

double ratio(std::size_t over, std::size_t under) { return static_cast<double>(over) / static_cast<double>(under); }

}  // namespace

[[gnu::noinline]] void paint_once(const std::function<void()>& paint) {
  paint();
  asm volatile("");  // something is left to do: a jump in place of the call would end the count
}

std::size_t total_of(const std::string& callgrind) {
  constexpr std::string_view before = "\ntotals: ";
  const std::size_t at = callgrind.find(before);
  std::size_t total = 0;
  if (at != std::string::npos)
    std::from_chars(callgrind.data() + at + before.size(), callgrind.data() + callgrind.size(), total);
  if (total == 0) throw std::runtime_error("expected a total above 0 in what callgrind wrote, found none");
  return total;
}

InstructionReport count_instructions(const RenderPlanOfBench& plan, Progress& progress) {
  const Callgrind callgrind(plan);
  InstructionReport report{this_machine(), plan, {}};
  for (const std::string& picture : names_of(plan)) {
    const auto count = [&](std::string_view line) {
      progress.say("counting instructions", picture + ", " + std::string(line));
      return callgrind.count(picture, line);
    };
    report.pictures.push_back({picture, count(plan_line), count(stripped_line), count(all_line)});
  }
  progress.clear();
  return report;
}

std::string text_of(const InstructionReport& report) {
  TextTable table;
  table.add_column("", "");
  for (const std::string_view line : {plan_line, stripped_line, all_line})
    table.add_column("instructions a pixel", std::string(line));
  table.add_column("plan", "over stripped");
  table.add_column("all effects", "over plan");
  const double pixels = static_cast<double>(report.plan.width) * report.plan.height;
  for (const InstructionCounts& each : report.pictures) {
    std::vector<std::string> cells{each.picture};
    for (const std::size_t count : {each.plan, each.stripped, each.all_effects})
      cells.push_back(number_text(static_cast<double>(count) / pixels, 5));
    cells.push_back(number_text(ratio(each.plan, each.stripped), 4));
    cells.push_back(number_text(ratio(each.all_effects, each.plan), 4));
    table.add_row(std::move(cells));
  }
  return machine_text(report.machine) + "\nInstructions of rendering alone, " + std::to_string(report.plan.width) +
         " x " + std::to_string(report.plan.height) + " pixels, as callgrind counts them\n\n" + table.text();
}

std::string json_text(const InstructionReport& report) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const InstructionCounts& each : report.pictures) {
    list.push_back({{"name", each.picture},
                    {"plan", each.plan},
                    {"stripped", each.stripped},
                    {"all_effects", each.all_effects},
                    {"plan_over_stripped", ratio(each.plan, each.stripped)}});
  }
  const nlohmann::ordered_json json{{"machine", json_of(report.machine)},
                                    {"width", report.plan.width},
                                    {"height", report.plan.height},
                                    {"instructions", list}};
  return json.dump(2) + '\n';
}

}  // namespace sightline::bench
