/// Wavefront OBJ, as far as it describes polygons: "v x y z" and "f a b c ..." with corners "a", "a/b", "a//c" or
/// "a/b/c", of which a counts vertices from 1, or backward from the last one when negative. Other statements of the
/// format are passed over, unknown ones refused.
#include <algorithm>
#include <array>

#include "sightline/io/polygons.h"
#include "sightline/io/text_reader.h"

namespace sightline {
namespace {

constexpr auto passed_over = std::to_array<std::string_view>(
    {"vt",       "vn",         "vp",        "p",     "l",     "g",      "o",   "s",    "mg",   "usemtl",
     "mtllib",   "usemap",     "maplib",    "lod",   "bevel", "cstype", "deg", "bmat", "step", "curv",
     "curv2",    "surf",       "parm",      "trim",  "hole",  "scrv",   "sp",  "end",  "con",  "c_interp",
     "d_interp", "shadow_obj", "trace_obj", "ctech", "stech", "call",   "csh"});

class ObjReader {
 public:
  ObjReader(const std::filesystem::path& path, std::string_view bytes) : reader_(path, bytes) {}

  Polygons read() {
    while (reader_.next_line()) {
      const std::string_view statement = reader_.word();
      if (statement == "v") {
        Vec3f& p = polygons_.positions.emplace_back();
        for (int axis = 0; axis < 3; ++axis) p[axis] = reader_.number("a coordinate");
      } else if (statement == "f" || statement == "fo") {
        read_face();
      } else if (std::find(passed_over.begin(), passed_over.end(), statement) != passed_over.end()) {
        while (!next_word().empty()) continue;  // to the end of a continued line
      } else if (!statement.empty() && statement[0] != '#') {
        reader_.fail("a statement of OBJ", "\"" + std::string(statement.substr(0, 20)) + "\"");
      }
    }
    // A face may name vertices that come later in the file.
    if (highest_ > static_cast<std::int64_t>(polygons_.positions.size())) {
      highest_at_.fail("a vertex number up to " + std::to_string(polygons_.positions.size()), std::to_string(highest_));
    }
    return std::move(polygons_);
  }

 private:
  /// A backslash at the end of a line joins the next line to it.
  std::string_view next_word() {
    std::string_view word = reader_.word();
    while (word == "\\" && !reader_.has_word() && reader_.next_line()) word = reader_.word();
    return !word.empty() && word[0] == '#' ? std::string_view() : word;
  }

  void read_face() {
    std::int64_t corners = 0;
    for (std::string_view word = next_word(); !word.empty(); word = next_word()) {
      const std::string_view number = word.substr(0, word.find('/'));
      const std::int64_t found = reader_.to_integer(number, "a vertex number");
      const auto count = static_cast<std::int64_t>(polygons_.positions.size());
      if (found == 0 || found < -count) {
        reader_.fail("a vertex number from 1, or from -" + std::to_string(count) + " to -1", number);
      }
      const std::int64_t index = found > 0 ? found : count + 1 + found;
      if (index > highest_) {
        highest_ = index;
        highest_at_ = reader_;
      }
      polygons_.corners.push_back(static_cast<std::uint32_t>(index - 1));
      ++corners;
    }
    reader_.check_corners(corners);
    polygons_.sizes.push_back(static_cast<std::uint32_t>(corners));
  }

  TextReader reader_;
  TextReader highest_at_ = reader_;
  Polygons polygons_;
  std::int64_t highest_ = 0;
};

}  // namespace

Polygons read_obj(const std::filesystem::path& path, std::string_view bytes) { return ObjReader(path, bytes).read(); }

}  // namespace sightline
