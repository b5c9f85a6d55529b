/// Solids as JSON: each kind of node is the tree that it says, and whatever else is there gets one line.
#include "sightline/scene/solid_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "sightline/csg/solid.h"
#include "sightline/math/random.h"
#include "tests/io/temporary_folder.h"

namespace sightline {
namespace {

SolidTree tree_of(const std::string& text) {
  const std::filesystem::path path = "s.json";
  const nlohmann::json json = parse_json(path, text);
  return solid_of(JsonValue(path, json));
}

/// The error, or "".
std::string refusal_of(const std::string& text) {
  try {
    tree_of(text);
  } catch (const FileError& error) {
    return error.what();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

template <class S>
S shape_of(const std::string& text) {
  const SolidTree tree = tree_of(text);
  EXPECT_EQ(tree.kind, SolidTree::Kind::primitive);
  EXPECT_TRUE(tree.frame.is_identity());
  EXPECT_EQ(tree.material, "");
  return std::get<S>(tree.shape);
}

const std::string ball = R"({"prim":"sphere","c":[0,0,0],"r":1})";

/// Everything that there is, in one document.
const std::string whole_document = R"({
  "op": "diff", "material": "red", "frame": {"translate": [1, 2, 3]}, "ignored": [{}, null],
  "args": [
    {"op": "union", "args": [
      {"prim": "box", "lo": [-1, -1, -1], "hi": [1, 1, 1]},
      {"prim": "sphere", "c": [0, 0, 1], "r": 0.5, "material": "blue"},
      {"prim": "cylinder", "p": [0, 0, -1], "q": [0, 0, 1], "r": 0.25},
      {"prim": "cone", "p": [0, 0, 2], "q": [0, 0, 1], "r": 1e-3}]},
    {"op": "xor", "frame": {"scale": [2, 2, -1]}, "args": [
      {"prim": "torus", "R": 1, "r": 0.25, "c": [0, 1, 0], "a": [1, 0, 0]},
      {"prim": "quadric", "q": [1, 2, 3, 4, 5, 6, 7, 8, 9, -10]}]},
    {"op": "inter", "args": [
      {"op": "compl", "args": [{"prim": "half", "n": [0, 1, 0], "w": 0.1}]},
      {"prim": "mesh", "v": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
       "f": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]}]}]})";

// ---- What is right

TEST(SolidFile, KnowsEachShape) {
  EXPECT_EQ(shape_of<solid::Box>(R"({"prim":"box","lo":[-1,0.1,2],"hi":[1e3,0.2,3]})"),
            (solid::Box{{-1, 0.1, 2}, {1000, 0.2, 3}}));
  EXPECT_EQ(shape_of<solid::Sphere>(R"({"prim":"sphere","c":[1,2,5e-324],"r":0.30000000000000004})"),
            (solid::Sphere{{1, 2, 5e-324}, 0.1 + 0.2}));
  EXPECT_EQ(shape_of<solid::HalfSpace>(R"({"prim":"half","n":[0,-2,1],"w":-0.5})"),
            (solid::HalfSpace{{0, -2, 1}, -0.5}));
  EXPECT_EQ(shape_of<solid::Cylinder>(R"({"prim":"cylinder","p":[1,2,3],"q":[4,5,6],"r":7})"),
            (solid::Cylinder{{1, 2, 3}, {4, 5, 6}, 7}));
  EXPECT_EQ(shape_of<solid::Cone>(R"({"prim":"cone","p":[1,2,3],"q":[4,5,6],"r":7})"),
            (solid::Cone{{1, 2, 3}, {4, 5, 6}, 7}));
  EXPECT_EQ(shape_of<Torus>(R"({"prim":"torus","R":2,"r":1})"), (Torus{Vec3d(0), {0, 0, 1}, 2, 1}));
  EXPECT_EQ(shape_of<Torus>(R"({"prim":"torus","R":2,"r":1,"c":[1,2,3],"a":[0,1,1]})"),
            (Torus{{1, 2, 3}, {0, 1, 1}, 2, 1}));
  EXPECT_EQ(shape_of<solid::Quadric>(R"({"prim":"quadric","q":[1,2,3,4,5,6,7,8,9,10]})"),
            (solid::Quadric{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10}}));
  const auto mesh = shape_of<std::shared_ptr<const ClosedMesh>>(
      R"({"prim":"mesh","v":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"f":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]})");
  EXPECT_EQ(mesh->vertices(), (std::vector<Vec3d>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(mesh->triangles(), (std::vector<ClosedMesh::Corners>{{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}));
}

TEST(SolidFile, KnowsEachOperation) {
  for (const OperationInfo& info : operation_infos) {
    for (const std::size_t count : {1u, 2u, 5u}) {
      std::string args;
      for (std::size_t i = 0; i < count; ++i) {
        args += (i > 0 ? "," : "") + (R"({"prim":"sphere","c":[0,0,0],"r":)" + std::to_string(i)) + "}";
      }
      const SolidTree tree = tree_of(R"({"op":")" + std::string(info.name) + R"(","args":[)" + args + "]}");
      EXPECT_EQ(tree.kind, SolidTree::Kind::operation);
      EXPECT_EQ(tree.operation, info.operation);
      ASSERT_EQ(tree.args.size(), count);
      for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(std::get<solid::Sphere>(tree.args[i].shape).radius, static_cast<double>(i));
      }
    }
  }
  const SolidTree tree = tree_of(R"({"op":"compl","args":[)" + ball + "]}");
  EXPECT_EQ(tree.kind, SolidTree::Kind::complement);
  ASSERT_EQ(tree.args.size(), 1u);
  EXPECT_EQ(tree.args[0].kind, SolidTree::Kind::primitive);
}

TEST(SolidFile, PassesFramesAndMaterialsOn) {
  const SolidTree tree = tree_of(whole_document);
  ASSERT_EQ(tree.args.size(), 3u);
  const SolidTree &sum = tree.args[0], &either = tree.args[1], &common = tree.args[2];
  EXPECT_EQ(tree.operation, Operation::subtract);
  EXPECT_EQ(sum.operation, Operation::unite);
  EXPECT_EQ(either.operation, Operation::differ);
  EXPECT_EQ(common.operation, Operation::intersect);
  ASSERT_EQ(sum.args.size(), 4u);
  EXPECT_EQ(sum.args[0].material, "red");
  EXPECT_EQ(sum.args[1].material, "blue");
  ASSERT_EQ(common.args.size(), 2u);
  EXPECT_EQ(common.args[0].kind, SolidTree::Kind::complement);
  // Rows take a point of the world to the shape's own place: moved first, then scaled back.
  using Rows = decltype(Frame::rows);
  EXPECT_EQ(sum.args[0].frame.rows, (Rows{{{1, 0, 0, -1}, {0, 1, 0, -2}, {0, 0, 1, -3}}}));
  EXPECT_EQ(either.args[0].frame.rows, (Rows{{{0.5, 0, 0, -0.5}, {0, 0.5, 0, -1}, {0, 0, -1, 3}}}));
  EXPECT_NO_THROW(Solid{tree});
}

TEST(SolidFile, ReadsFiles) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_solid(folder.write("a.json", whole_document)).args.size(), 3u);
  EXPECT_EQ(read_solid(folder.write("b.json", "\n\t " + ball + "\r\n")).kind, SolidTree::Kind::primitive);
}

TEST(SolidFile, KeepsTheTriangles) {
  const nlohmann::json json = nlohmann::json::parse(R"({"v":[[0,0,0],[1,0,0],[0,1,0]],"f":[[0,1,2],[2,2,2]]})");
  const std::filesystem::path path = "m.json";
  const TriangleList list = triangles_of(JsonValue(path, json));  // open, and one of no area: for others to judge
  EXPECT_EQ(list.vertices.size(), 3u);
  EXPECT_EQ(list.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {2, 2, 2}}));
}

// ---- What is wrong

struct Case {
  std::string text;
  std::string refusal;  ///< Behind the file's name.
};

void expect_refusals(const std::vector<Case>& cases) {
  for (const auto& [text, refusal] : cases) EXPECT_EQ(refusal_of(text), "s.json" + refusal) << text;
}

TEST(SolidFile, TellsWhatIsMissing) {
  expect_refusals({
      {"{}", R"(:/: expected a member "op" or "prim", found none)"},
      {R"({"prim":"box","op":"union"})", R"(:/: expected a member "op" or "prim", found both)"},
      {R"({"prim":"box"})", R"(:/: expected a member "lo", found none)"},
      {R"({"prim":"box","lo":[0,0,0]})", R"(:/: expected a member "hi", found none)"},
      {R"({"prim":"sphere","r":1})", R"(:/: expected a member "c", found none)"},
      {R"({"prim":"sphere","c":[0,0,0]})", R"(:/: expected a member "r", found none)"},
      {R"({"prim":"half","w":1})", R"(:/: expected a member "n", found none)"},
      {R"({"prim":"half","n":[0,0,1]})", R"(:/: expected a member "w", found none)"},
      {R"({"prim":"cylinder","p":[0,0,0],"r":1})", R"(:/: expected a member "q", found none)"},
      {R"({"prim":"cone","q":[0,0,0],"r":1})", R"(:/: expected a member "p", found none)"},
      {R"({"prim":"torus","r":1})", R"(:/: expected a member "R", found none)"},
      {R"({"prim":"quadric"})", R"(:/: expected a member "q", found none)"},
      {R"({"prim":"mesh","v":[]})", R"(:/: expected a member "f", found none)"},
      {R"({"op":"union"})", R"(:/: expected a member "args", found none)"},
      {R"({"op":"union","args":[]})", ":/args: expected at least 1 argument, found 0"},
      {R"({"op":"compl","args":[]})", ":/args: expected 1 argument, found 0"},
      {R"({"op":"compl","args":[)" + ball + "," + ball + "]}", ":/args: expected 1 argument, found 2"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"frame":{"rotate":{"axis":[0,0,1]}}})",
       R"(:/frame/rotate: expected a member "degrees", found none)"},
  });
}

TEST(SolidFile, TellsWhatIsOfAnotherKind) {
  expect_refusals({
      {"null", ":/: expected an object, found null"},
      {"5", ":/: expected an object, found 5"},
      {"[]", ":/: expected an object, found []"},
      {R"({"prim":5})", ":/prim: expected a string, found 5"},
      {R"({"prim":"Box"})",
       R"(:/prim: expected one of box, sphere, half, cylinder, cone, torus, quadric, mesh, found "Box")"},
      {R"({"op":"and","args":[]})", R"(:/op: expected one of union, inter, diff, xor, compl, found "and")"},
      {R"({"op":["union"],"args":[]})", R"(:/op: expected a string, found ["union"])"},
      {R"({"op":"union","args":{}})", ":/args: expected an array, found {}"},
      {R"({"op":"union","args":[)" + ball + ",7]}", ":/args/1: expected an object, found 7"},
      {R"({"prim":"box","lo":[0,0],"hi":[1,1,1]})", ":/lo: expected 3 numbers, found [0,0]"},
      {R"({"prim":"box","lo":[0,0,"1"],"hi":[1,1,1]})", R"(:/lo/2: expected a number, found "1")"},
      {R"({"prim":"box","lo":{"x":0},"hi":[1,1,1]})", R"(:/lo: expected an array, found {"x":0})"},
      {R"({"prim":"sphere","c":[0,0,0],"r":"Infinity"})", R"(:/r: expected a number, found "Infinity")"},
      {R"({"prim":"sphere","c":[0,0,0],"r":true})", ":/r: expected a number, found true"},
      {R"({"prim":"quadric","q":[1,2,3]})", ":/q: expected 10 numbers, found 3"},
      {R"({"prim":"torus","R":2,"r":1,"a":[0,0]})", ":/a: expected 3 numbers, found [0,0]"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"material":5})", ":/material: expected a string, found 5"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"frame":5})", ":/frame: expected an object, found 5"},
      {R"({"prim":"mesh","v":[[0,0,0]],"f":[[0,0]]})", ":/f/0: expected 3 vertices, found [0,0]"},
      {R"({"prim":"mesh","v":[[0,0,0]],"f":[[0,0,1.5]]})", ":/f/0/2: expected a whole number, found 1.5"},
      {R"({"prim":"mesh","v":[[0,0,0]],"f":[[0,-1,0]]})", ":/f/0/1: expected a whole number, found -1"},
  });
}

TEST(SolidFile, TellsWhatMakesNoSense) {
  expect_refusals({
      {R"({"prim":"box","lo":[0,2,0],"hi":[1,1.5,1]})",
       ":/: expected a box's lo not above its hi on axis y, found 2 and 1.5"},
      {R"({"prim":"sphere","c":[0,0,0],"r":-1e-300})",
       ":/: expected a sphere's radius that is finite and not negative, found -1e-300"},
      {R"({"prim":"cylinder","p":[0,0,0],"q":[0,0,1],"r":-1})",
       ":/: expected a cylinder's radius that is finite and not negative, found -1"},
      {R"({"prim":"cone","p":[0,0,0],"q":[0,0,1],"r":-1})",
       ":/: expected a cone's radius that is finite and not negative, found -1"},
      {R"({"prim":"torus","R":-2,"r":1})", ":/: expected a torus's radius R that is finite and not negative, found -2"},
      {R"({"prim":"torus","R":2,"r":-1})", ":/: expected a torus's radius r that is finite and not negative, found -1"},
      {R"({"prim":"torus","R":2,"r":1,"a":[0,0,0]})", ":/: expected a torus's axis that is not zero, found zero"},
      {R"({"prim":"half","n":[0,0,0],"w":1})", ":/: expected a half-space's normal that is not zero, found zero"},
      {R"({"prim":"cylinder","p":[1,2,3],"q":[1,2,3],"r":1})",
       ":/: expected two ends of the cylinder that are apart, found one point"},
      {R"({"prim":"cone","p":[1,2,3],"q":[1,2,3],"r":1})",
       ":/: expected two ends of the cone that are apart, found one point"},
      {R"({"prim":"mesh","v":[[0,0,0]],"f":[]})", ":/: closed mesh: expected triangles, found none"},
      {R"({"prim":"mesh","v":[[0,0,0],[1,0,0],[0,1,0]],"f":[[0,1,2]]})",
       ":/: closed mesh: triangle 0: expected its edge from vertex 0 to 1 to be another triangle's from 1 to 0, found "
       "it open"},
      {R"({"prim":"mesh","v":[[0,0,0]],"f":[[0,0,1]]})", ":/f/0/2: expected a vertex below 1, found 1"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"frame":{"scale":[1,0,1]}})",
       ":/frame/scale: expected a scale other than 0, found [1,0,1]"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"frame":{"scale":1e-320}})",
       ":/frame/scale: expected a scale other than 0, found 1e-320"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1,"frame":{"rotate":{"axis":[0,0,0],"degrees":1}}})",
       ":/frame/rotate/axis: expected an axis other than 0, found [0,0,0]"},
      {R"({"op":"diff","args":[)" + ball + R"(,{"op":"inter","args":[{"prim":"sphere","c":[0,0,0],"r":-2}]}]})",
       ":/args/1/args/0: expected a sphere's radius that is finite and not negative, found -2"},
  });
}

TEST(SolidFile, TellsWhereItIsNoJson) {
  expect_refusals({
      {R"({"prim":"sphere","c":[0,0,0],"r":NaN})", ":1: expected JSON, found 'NaN}' at byte 34"},
      {"{\"prim\":\"sphere\",\n\"c\":[0,0,Infinity],\n\"r\":1}", ":2: expected JSON, found 'Infinity],' at byte 28"},
      {R"({"prim":"sphere","c":[0,0,0],"r":1e999})", ":1: expected a number that a double holds, found 1e999"},
      {"\n{\"r\":-1e400}", ":2: expected a number that a double holds, found -1e400"},
      {ball + " x", ":1: expected JSON, found 'x' at byte 37"},
      {ball.substr(0, ball.size() - 1), ":1: expected JSON, found the end at byte 34"},
      {"", ":1: expected JSON, found the end at byte 0"},
      {"\xff.", ":1: expected JSON, found '?.' at byte 1"},
  });
}

TEST(SolidFile, TellsOfFiles) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) -> std::string {
    try {
      read_solid(path);
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  };
  const std::string name = folder.path().string();
  EXPECT_EQ(refusal(folder.write("empty.json", "")),
            name + "/empty.json: expected a file with something in it, found an empty one");
  EXPECT_EQ(refusal(folder.path() / "none.json"),
            name + "/none.json: expected a file, found No such file or directory");
  EXPECT_EQ(refusal(folder.path()), name + ": expected a file, found a folder");
  EXPECT_EQ(refusal(folder.write("a\nb.json", "[]")), name + "/a?b.json:/: expected an object, found []");
  std::string garbage(10'000'000, '\0');
  Random random(5);
  for (char& c : garbage) c = static_cast<char>(random.next() >> 8);
  garbage[0] = '\x01';
  EXPECT_EQ(refusal(folder.write("garbage.json", garbage)).substr(name.size(), 29), "/garbage.json:1: expected JSO");
  EXPECT_EQ(refusal(folder.write("blank.json", std::string(10'000'000, ' '))),
            name + "/blank.json:1: expected JSON, found the end at byte 10000000");
}

bool is_one_line(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

TEST(SolidFile, RefusesWhatIsTooDeep) {
  const auto nested = [](int levels) {
    std::string text;
    for (int i = 0; i < levels; ++i) text += R"({"op":"compl","args":[)";
    text += ball;
    for (int i = 0; i < levels; ++i) text += "]}";
    return text;
  };
  // An object and an array a level, and of the ball its object and its center.
  EXPECT_EQ(refusal_of(nested((deepest_json - 2) / 2)), "");
  const std::string refusal = "s.json: expected at most 1000 arrays and objects within each other, found more at byte ";
  EXPECT_EQ(refusal_of(nested(deepest_json / 2)).substr(0, refusal.size()), refusal);
  EXPECT_EQ(refusal_of(nested(100'000)).substr(0, refusal.size()), refusal);
  EXPECT_EQ(refusal_of(std::string(10'000'000, '[')).substr(0, refusal.size()), refusal);
}

TEST(SolidFile, RefusesAllThatIsCutOff) {
  for (std::size_t size = 0; size < whole_document.size(); ++size) {
    const std::string refusal = refusal_of(whole_document.substr(0, size));
    ASSERT_NE(refusal.find("expected JSON, found "), std::string::npos) << size << ": " << refusal;
    ASSERT_TRUE(is_one_line(refusal)) << size;
  }
}

/// Bytes and words changed, moved and doubled at random: a tree that can be evaluated, or one line.
TEST(SolidFile, BearsAnything) {
  const std::vector<std::string> words{"-1", "1e308", "-1e308",  "5e-324",  "1e999", "NaN",  "null", "true",  "{}",
                                       "[]", "\"\"",  "\\u0000", "\\ud800", "\"",    "{",    "}",    "[",     "]",
                                       ",",  ":",     "\xff",    "0",       "compl", "mesh", "half", "frame", "scale"};
  Random random(11);
  int trees = 0, refusals = 0;
  for (int round = 0; round < 20'000; ++round) {
    std::string text = whole_document;
    for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
      const std::size_t at = random.below(static_cast<std::uint32_t>(text.size()));
      const std::string& word = words[random.below(static_cast<std::uint32_t>(words.size()))];
      const std::size_t count = 1 + random.below(12);
      switch (random.below(5)) {
        case 0:
          text[at] = static_cast<char>(random.next() >> 8);
          break;
        case 1:
          text.erase(at, count);
          break;
        case 2:
          text.insert(at, word);
          break;
        case 3:
          text.replace(at, std::min<std::size_t>(count, 3), word);
          break;
        default:
          text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), count));
          break;
      }
    }
    try {
      const SolidTree tree = tree_of(text);
      ++trees;
      ASSERT_NO_THROW(Solid{tree}) << text;
    } catch (const FileError& error) {
      ++refusals;
      ASSERT_TRUE(is_one_line(error.what())) << text;
    } catch (const std::invalid_argument& error) {
      ++refusals;
      ASSERT_TRUE(is_one_line(error.what())) << text;
    }
  }
  EXPECT_GT(trees, 300);
  EXPECT_GT(refusals, 5000);
}

}  // namespace
}  // namespace sightline
