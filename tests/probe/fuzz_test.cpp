/// Broken lines: whatever is in one, it is answered by one line of JSON.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "sightline/math/random.h"
#include "viz/probe/answer.h"

namespace sightline {
namespace {

using nlohmann::json;

const std::vector<std::string>& seeds() {
  static const std::vector<std::string> all{
      R"({"id":1,"ray":{"o":[-3,0.5,0],"d":[1,0,0.25]},"sphere":{"c":[0,0,0],"r":1}})",
      R"({"id":"two","ray":{"o":[-10,2,1],"d":[1,0,0]},"torus":{"R":2,"r":1,"c":[0,0,1e-3]}})",
      R"({"ray":{"o":[0,0,0],"d":[1,1,1]},"box":{"lo":[-1,-1,-1],"hi":[1,2,3]}})",
      R"({"id":[3,{}],"ray":{"o":[0,0,0],"d":[1,0,0]},"mesh":{"v":[[1,0,0],[1,1,0],[1,0,1]],"f":[[0,1,2],[2,1,0]]}})",
      R"({"id":4,"ray":{"o":[0,0,-3],"d":[0,0.5,1]},"tree":{"op":"diff","args":[{"prim":"box","lo":[-1,-1,-1],)"
      R"("hi":[1,1,1]},{"prim":"sphere","c":[0,0,0],"r":0.5},{"op":"compl","args":[{"prim":"half","n":[1,0,0],)"
      R"("w":0}]}]}})",
      R"({"id":5,"ray":{"o":[0,0,-3],"d":[0,0.5,1]},"tree":{"op":"xor","frame":{"translate":[1,0,0],"rotate":{)"
      R"("axis":[1,1,0],"degrees":30},"scale":[1,2,-1]},"args":[{"prim":"cylinder","p":[0,0,-1],"q":[0,0,1],"r":1},)"
      R"({"prim":"cone","p":[0,0,1],"q":[0,0,-1],"r":1},{"prim":"torus","R":1,"r":0.5,"material":"red"},)"
      R"({"prim":"quadric","q":[1,1,1,0,0,0,0,0,0,-1]}]}})",
      R"({"id":6,"ray":{"o":[0.25,0.25,-3],"d":[0,0,1]},"tree":{"prim":"mesh","v":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],)"
      R"("f":[[0,2,1],[0,1,3],[0,3,2],[1,2,3]]}})"};
  return all;
}

std::string mutated(std::string text, Random& random) {
  static const std::vector<std::string> tokens{"-1",
                                               "0",
                                               "1e999",
                                               "1e308",
                                               "-1e308",
                                               "5e-324",
                                               "1e-160",
                                               "NaN",
                                               "Infinity",
                                               "null",
                                               "true",
                                               "{}",
                                               "[]",
                                               "[[]]",
                                               "\"\"",
                                               "\"o\"",
                                               "\\u0000",
                                               "\\ud800",
                                               "\\",
                                               "\"",
                                               "{",
                                               "}",
                                               "[",
                                               "]",
                                               ",",
                                               ":",
                                               "\xff",
                                               "\xc3",
                                               std::string(1, '\0'),
                                               "99999999999999999999",
                                               "4294967296",
                                               "0.1",
                                               "-0",
                                               "\"op\"",
                                               "\"compl\"",
                                               "\"union\"",
                                               "{\"op\":\"inter\",\"args\":["};
  for (std::uint32_t changes = 1 + random.below(2); changes > 0 && !text.empty(); --changes) {
    const std::uint32_t at = random.below(static_cast<std::uint32_t>(text.size()));
    const std::string& token = tokens[random.below(static_cast<std::uint32_t>(tokens.size()))];
    switch (random.below(12)) {
      case 0:
        text.resize(at);
        break;
      case 1:
        text[at] = static_cast<char>(random.next());
        break;
      case 2:
        text.insert(at, token);
        break;
      case 3:
        text.erase(at, 1 + random.below(6));
        break;
      case 4:
        text.insert(at, text.substr(random.below(static_cast<std::uint32_t>(text.size())), 30));
        break;
      default: {  // a number for another
        const std::size_t from = text.find_first_of("0123456789", at);
        if (from == text.npos) break;
        text.replace(from, text.find_first_not_of("0123456789.e+-", from) - from, token);
      }
    }
  }
  return text;
}

/// True where the line was answered.
bool answered(const std::string& line, Level level) {
  const probe::Answer answer = probe::answer(line, 12, level);
  EXPECT_EQ(answer.text.find('\n'), std::string::npos);
  const json parsed = json::parse(answer.text, nullptr, false);
  EXPECT_TRUE(parsed.is_object()) << answer.text;
  if (answer.is_good) {
    EXPECT_TRUE(parsed.contains("t_first"));
    EXPECT_FALSE(parsed.contains("error"));
    return true;
  }
  EXPECT_EQ(parsed["line"], 12);
  EXPECT_TRUE(parsed["error"].is_string());
  EXPECT_NE(parsed["error"].get<std::string>().find(": "), std::string::npos) << parsed;
  EXPECT_NE(parsed["error"].get<std::string>().find("expected "), std::string::npos) << parsed;
  EXPECT_NE(parsed["error"].get<std::string>().find("found "), std::string::npos) << parsed;
  EXPECT_FALSE(parsed["error"].get<std::string>().starts_with(":")) << parsed;
  return false;
}

TEST(ProbeFuzz, EveryMutantHasItsAnswer) {
  Random random(1);
  int good = 0;
  constexpr int mutants = 100'000;
  for (int i = 0; i < mutants; ++i) {
    const std::string line = mutated(seeds()[random.below(static_cast<std::uint32_t>(seeds().size()))], random);
    good += answered(line, level_infos[static_cast<std::size_t>(i) % level_infos.size()].level);
    ASSERT_FALSE(HasFailure()) << "mutant " << i << ": " << line;
  }
  EXPECT_GT(good, mutants / 20);
  EXPECT_LT(good, mutants * 19 / 10);
}

TEST(ProbeFuzz, EveryPrefixIsRefused) {
  for (const std::string& seed : seeds()) {
    ASSERT_TRUE(answered(seed, Level::watertight)) << seed;
    for (std::size_t size = 0; size < seed.size(); ++size) {
      EXPECT_FALSE(answered(seed.substr(0, size), Level::watertight)) << seed.substr(0, size);
    }
  }
}

TEST(ProbeFuzz, NestingIsLimited) {
  for (const std::size_t depth : {999u, 1001u, 100'000u, 5'000'000u}) {
    EXPECT_FALSE(answered(std::string(depth, '['), Level::watertight));
    EXPECT_FALSE(answered(std::string(depth, '[') + std::string(depth, ']'), Level::watertight));
    EXPECT_FALSE(answered("{\"id\":" + std::string(depth, '[') + std::string(depth, ']') + "}", Level::watertight));
  }
  for (const int depth : {10, 200, 300}) {
    std::string tree = R"({"prim":"sphere","c":[0,0,0],"r":1})";
    for (int i = 0; i < depth; ++i) tree = R"({"op":"compl","args":[)" + tree + "]}";
    EXPECT_TRUE(answered(R"({"ray":{"o":[0,0,0],"d":[1,0,0]},"tree":)" + tree + "}", Level::watertight)) << depth;
  }
}

TEST(ProbeFuzz, IdsComeBack) {
  for (const char* id : {"0", "-1.5", "null", "\"x\\u00e9\"", "[1,{\"a\":[]}]", "true", "123456789012345678"}) {
    const std::string head = std::string("{\"id\":") + id + ",\"ray\":{\"o\":[0,0,0],\"d\":[1,0,0]},";
    for (const char* shape : {R"("sphere":{"c":[3,0,0],"r":1}})", R"("sphere":{"c":[3,0,0]}})", R"("cube":1})"}) {
      const probe::Answer answer = probe::answer(head + shape, 3, Level::exact);
      EXPECT_EQ(json::parse(answer.text)["id"], json::parse(id)) << answer.text;
    }
  }
}

}  // namespace
}  // namespace sightline
