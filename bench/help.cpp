#include "bench/help.h"

#include <sstream>

#include "bench/peers/peers.h"
#include "bench/plan.h"
#include "sightline/scene/scenes.h"

namespace sightline::bench {
namespace {

constexpr std::string_view introduction_text =
    R"(Measures every structure of the library beside Embree: how fast it is built, how
much memory it takes, and how fast it answers rays.

Every hit is verified before the first time is shown. Where one of our structures
is wrong in a single bit, the run names the ray and ends with exit code 1.
)";

constexpr std::string_view reading_text = R"(
How to read the table:
  build      Milliseconds from the mesh to a structure that is ready to be asked.
  memory     Bytes a triangle takes: nodes, leaf order, copies of triangles.
  Mrays/s    Million rays a second, one by one on one thread. More is better.
  (0.25x)    That speed over Embree's: a quarter of it. Taken round by round, as
             the median, so that a busy machine disturbs it little.
  nodes      Inner nodes and empty cells that a ray opens: the structure's part.
  candidates Triangles that a ray is tested against: what the structure leaves over.
  fast       Asked at --precision fast; lines without it decide exactly.
  stream     All rays handed over together; lines without it take them one by one.
  ####|      Below several scenes: slower than Embree, which is |; |## is twice as fast.
  times      Under the table: time per ray of one line over that of another.
  Digits     end where the measurement's uncertainty begins.

Examples:
  sightline-bench --quick                      a first impression
  sightline-bench --accel kd-tree,bih --scene dragon:3 --rounds 21
  sightline-bench --accel kd-tree --accel kd-tree:max_leaf_size=16
                                               one structure against itself
  sightline-bench --precision fast,watertight  what exact decisions cost
  sightline-bench --accel wide-tree --stream   single rays beside many at once
  sightline-bench --scene soup:100000 --workload build --threads 1
  sightline-bench --json out/bench.json        with all rounds, for other tools
  sightline-bench --scene dragon:3 --peer all  beside CGAL and VTK as well
  sightline-bench --scene sticks               where boxes collapse
  sightline-bench --growth soup                exponents of time against triangles
  sightline-bench solids --help                solids beside POV-Ray
  sightline-bench instances --help             two levels beside Embree's instances
  sightline-bench moving --help                refitting beside building anew
  sightline-bench render --help                pictures, beside a renderer stripped by hand
  sightline-bench torus --help                 roots of tori beside Ferrari's closed form
  sightline-bench graph --help                 scene graphs: places, bounds, updates
  sightline-bench -- --benchmark_filter=bih    flags of Google Benchmark

Exit code: 0; 1 when a file cannot be read or written or hits are wrong; 2 when
the command line is.
)";

constexpr std::size_t width = 88;

std::string wrapped(const std::string& text, std::size_t indent) {
  std::istringstream words(text);
  std::string out, line;
  const auto flush = [&] { out += std::string(indent, ' ') + line + '\n'; };
  for (std::string word; words >> word;) {
    if (!line.empty() && indent + line.size() + 1 + word.size() > width) {
      flush();
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) flush();
  return out;
}

}  // namespace

std::string_view introduction() { return introduction_text; }
std::string_view reading() { return reading_text; }

std::string catalogue() {
  std::string text = "\nWorkloads:\n";
  for (const WorkloadInfo& info : workload_infos) {
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6);
  }
  text += "\nLevels, for --precision:\n";
  for (const Level level : triangle_levels) {
    const LevelInfo& info = info_of(level);
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.help), 6);
  }
  text += "\nScenes (NAME or NAME:SIZE, or the path of an OBJ, PLY, STL, OFF or glTF file):\n";
  for (const SceneInfo& info : scene_infos()) {
    const std::string sizes = "Sizes " + std::to_string(info.lowest) + " to " + std::to_string(info.highest) +
                              ", normally " + std::to_string(info.default_size) + '.';
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6) + wrapped(sizes, 6);
  }
  text += "\nAccelerators and their options:\n";
  for (const AcceleratorInfo& info : accelerator_infos()) {
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6);
    for (const AcceleratorInfo::Option& option : info.options) {
      text += "      " + std::string(option.name) + " = " + option.default_value + "   (" + option.allowed + ")\n" +
              wrapped(std::string(option.help), 10);
    }
  }
  text += "\nPeers, for --peer:\n";
  for (const PeerInfo& info : peer_infos()) {
    text += "  " + std::string(info.name) + '\n' + wrapped(std::string(info.description), 6);
    if (!info.make) text += wrapped("Not in this build, for want of " + std::string(info.package) + '.', 6);
  }
  return text;
}

}  // namespace sightline::bench
