/// sightline-probe: where rays meet solids, asked and answered in lines of JSON.

#include <cstdio>
#include <fstream>
#include <iostream>
#include <stdexcept>

#include "viz/probe/answer.h"
#include "viz/run_tool.h"

namespace sightline::probe {
namespace {

/// Longer lines are refused, so that one cannot take all memory.
constexpr std::size_t longest_line = std::size_t{64} << 20;

constexpr const char* about = R"(Answers where rays meet solids: reads lines of JSON, and writes one line for each.

  {"id": 1, "ray": {"o": [x, y, z], "d": [x, y, z]}, SHAPE}

t is in units of the direction d, which need not have length 1. An id may be any value, or missing; the answer has it
again. SHAPE is one of

  "sphere": {"c": [3], "r": radius}
  "torus": {"R": major, "r": minor}              around the z axis, and 0 or a center "c": [3]
      {"id", "roots": [...], "multiplicity": [...], "t_first"}
      all real t of the whole line, ascending; one where the line touches has multiplicity 2 or more
  "box": {"lo": [3], "hi": [3]}
      {"id", "hit", "enter", "exit", "t_first"}
      the closed box against the whole line, be it behind the origin: touching an edge or a corner, and lying in a
      face, is a hit. enter and exit are null where it is missed
  "mesh": {"v": [[3], ...], "f": [[a, b, c], ...]}         triangles of vertices counted from 0, closed or not
      {"id", "t": [...], "tris": [[...], ...], "t_first"}
      the distinct t >= 0, ascending, and the triangles that are met at each. Edges and vertices belong to all their
      triangles. A triangle that the ray lies in, or that has no area, is not met
  "tree": NODE
      {"id", "intervals": [[a, b], ...], "t_first"}
      where the whole line is inside, as a regularised set: intervals without length vanish, abutting ones are one;
      the ends may be "-inf" and "inf"

A NODE is {"op": "union|inter|diff|xor|compl", "args": [NODE, ...]}, where diff takes all others from the first and
compl has one argument, or one of
  {"prim": "box", "lo": [3], "hi": [3]}          {"prim": "sphere", "c": [3], "r": radius}
  {"prim": "half", "n": [3], "w": offset}        the points x with n.x <= w
  {"prim": "cylinder", "p": [3], "q": [3], "r": radius}    capped at p and q
  {"prim": "cone", "p": [3], "q": [3], "r": radius}        from the apex p to the base around q
  {"prim": "torus", "R": major, "r": minor}      with "c": [3], its center, and "a": [3], its axis, normally 0 and z
  {"prim": "quadric", "q": [10]}                 of x^2 y^2 z^2 xy xz yz x y z 1: where the sum is <= 0
  {"prim": "mesh", "v": [...], "f": [...]}       a closed one, counter-clockwise as seen from outside
and may have a "material", and a "frame": {"scale": s or [3], "rotate": {"axis": [3], "degrees": a}, "translate": [3]}
(done in this order) that it stands in with all its arguments.

t_first is the smallest of these t, or ends of intervals, that is >= 0, or null. So from within a box or a solid it is
where the ray leaves, and 0 from a boundary. Other members are ignored.

A line that is no such question is answered by {"line": n, "error": "..."}, with its id if that can be read: where in
the line, what was expected and what was found. Blank lines are skipped.

Examples
  echo '{"ray": {"o": [-3, 0, 0], "d": [1, 0, 0]}, "sphere": {"c": [0, 0, 0], "r": 1}}' | sightline-probe
  sightline-probe --precision exact questions.jsonl

Exit status: 0 all lines were answered, 1 some could not be, or the file could not be read, 2 wrong usage.)";

enum class Read { line, too_long, end };

/// The next line without its end; of one that is too long the beginning, and the rest is skipped.
Read read_line(std::istream& in, std::string& line) {
  line.clear();
  std::streambuf& buffer = *in.rdbuf();
  constexpr int end = std::char_traits<char>::eof();
  bool is_too_long = false;
  int c = buffer.sbumpc();
  if (c == end) return Read::end;
  for (; c != end && c != '\n'; c = buffer.sbumpc()) {
    if (line.size() == longest_line) {
      is_too_long = true;
    } else {
      line.push_back(static_cast<char>(c));
    }
  }
  return is_too_long ? Read::too_long : Read::line;
}

int answer_all(std::istream& in, Level level) {
  int status = success;
  std::string line;
  for (std::size_t number = 1;; ++number) {
    const Read read = read_line(in, line);
    if (read == Read::end) break;
    if (line.find_first_not_of(" \t\r\v\f") == std::string::npos) continue;
    const Answer answered =
        read == Read::too_long ? refuse_long_line(longest_line, number) : answer(line, number, level);
    if (!answered.is_good) status = failure;
    std::cout << answered.text << '\n' << std::flush;
    if (!std::cout) throw std::runtime_error("cannot write the answers");
  }
  if (in.bad()) throw std::runtime_error("cannot read on");
  return status;
}

int run(int argc, char** argv) {
  CLI::App app(about, "sightline-probe");
  std::string file = "-", precision(info_of(Level::watertight).name);
  app.add_option("FILE", file, "Lines of JSON; normally, and for -, those of the standard input")->option_text("");
  std::string help = "How accurate numbers and decisions are; default watertight";
  std::string names;
  for (const LevelInfo& info : level_infos) names += (names.empty() ? "" : "|") + std::string(info.name);
  help +=
      "\n  fast: computed in float, without promises"
      "\n  watertight: every decision is exact, and t is off by less than 2^-46 of itself"
      "\n  precise: t is off by less than its last place"
      "\n  exact: t is rounded correctly";
  app.add_option("--precision", precision, help)->option_text(names);
  if (const std::optional<int> status = parse(app, argc, argv)) return *status;
  for (const LevelInfo& info : level_infos) {
    if (info.name != precision) continue;
    if (file == "-") return answer_all(std::cin, info.level);
    std::ifstream in(file, std::ios::binary);
    if (!in || in.peek() == std::ifstream::traits_type::eof()) {
      if (!in.is_open() || in.bad()) throw std::runtime_error(file + ": cannot be read");
    }
    return answer_all(in, info.level);
  }
  throw std::invalid_argument("--precision: expected one of " + names + ", found " + precision);
}

}  // namespace
}  // namespace sightline::probe

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  return sightline::run_tool("sightline-probe", [&] { return sightline::probe::run(argc, argv); });
}
