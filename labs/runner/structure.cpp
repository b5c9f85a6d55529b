#include "labs/runner/structure.h"

#include <algorithm>
#include <cctype>
#include <iterator>

#include "bench/run_program.h"
#include "sightline/io/file_error.h"
#include "sightline/io/output_file.h"
#include "viz/child_process.h"

namespace sightline::labs {
namespace {

namespace fs = std::filesystem;

/// "quad_tree": "QuadTree".
std::string pascal_case(const std::string& snake) {
  std::string name;
  bool begins = true;
  for (const char c : snake) {
    if (c == '_' || c == '-') {
      begins = true;
    } else {
      name += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
      begins = false;
    }
  }
  return name;
}

/// Compiles a source text with the structure's header in front of it, unless that is done.
Compiled compile_with(const Workshop& workshop, const OwnStructure& structure, const std::string& what,
                      const std::string& text, const fs::path& target, const std::vector<std::string>& words) {
  const fs::path build = structure.header.parent_path() / ".build" / structure.name();
  const fs::path source = build / (what + ".cpp"), made = build / target, log = build / (what + ".log");
  std::error_code none;
  const auto time = fs::last_write_time(made, none);
  bool is_made = !none;
  for (const std::string& word : workshop.toolchain().libraries) {
    is_made = is_made && (!word.starts_with("/") || fs::last_write_time(word, none) < time);
  }
  // Whatever else the student's folder holds may be included.
  for (const auto& entry : fs::directory_iterator(structure.header.parent_path(), none)) {
    is_made = is_made && (!entry.is_regular_file() || entry.last_write_time() < time);
  }
  if (is_made) return {true, made, {}};
  write_text(source, "#include \"" + structure.header.filename().string() + "\"\n" + text);
  fs::remove(made, none);
  const Toolchain& tools = workshop.toolchain();
  std::vector<std::string> command{tools.compiler};
  command.insert(command.end(), tools.flags.begin(), tools.flags.end());
  command.insert(command.end(), {"-I" + structure.header.parent_path().string(), source, "-o", made});
  command.insert(command.end(), words.begin(), words.end());
  const bool is_built = bench::run_program(command, log) == 0;
  return {is_built, made, bench::text_in(log)};
}

}  // namespace

std::vector<OwnStructure> dropped_in(const Workshop& workshop) {
  std::vector<OwnStructure> found;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(workshop.mine(), none)) {
    if (entry.path().extension() != ".h") continue;
    found.push_back({entry.path(), "student::" + pascal_case(entry.path().stem().string())});
  }
  std::ranges::sort(found, {}, &OwnStructure::header);
  return found;
}

Compiled compile_plugin(const Workshop& workshop, const OwnStructure& structure) {
  // As fast as ours: they are compiled at -O3.
  return compile_with(workshop, structure, "plugin",
                      "#include \"sightline/query/structure_plugin_of.h\"\n\n"
                      "extern \"C\" const sightline::StructurePlugin sightline_structure =\n"
                      "    sightline::structure_plugin_of<" +
                          structure.type + ">();\n",
                      structure.name() + ".so", {"-O3", "-DNDEBUG", "-fPIC", "-shared"});
}

Compiled compile_laws(const Workshop& workshop, const OwnStructure& structure) {
  std::vector<std::string> words{"-lgtest_main", "-lgtest"};
  std::ranges::copy(workshop.toolchain().libraries, std::back_inserter(words));
  return compile_with(workshop, structure, "laws",
                      "#include \"tests/accel/laws.h\"\n\nnamespace sightline::laws {\n"
                      "INSTANTIATE_TYPED_TEST_SUITE_P(Mine, Laws, ::testing::Types<" +
                          structure.type + ">, NameOf);\n}  // namespace sightline::laws\n",
                      "laws", words);
}

int run_with(const Workshop& workshop, const std::string& program, std::vector<std::string> words) {
  const fs::path path = workshop.program(program);
  if (!fs::exists(path)) throw FileError(path, 0, "a program of this build", "none; build it with ./sightline");
  return viz::run_program(path, words);
}

}  // namespace sightline::labs
