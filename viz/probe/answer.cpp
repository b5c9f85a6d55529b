#include "viz/probe/answer.h"

#include <array>
#include <limits>
#include <stdexcept>

#include "sightline/io/json_value.h"
#include "sightline/scene/solid_frame.h"
#include "viz/probe/crossings.h"

namespace sightline::probe {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// A question that cannot be answered: what() says where, what was expected and what was found.
struct BadQuestion : std::runtime_error {
  using runtime_error::runtime_error;
};

const std::filesystem::path no_file;  // places are within the line alone

json parsed(std::string_view question) {
  if (const std::size_t at = too_deep_at(question); at < question.size()) {
    throw BadQuestion("byte " + std::to_string(at + 1) + ": expected at most " + std::to_string(deepest_json) +
                      " arrays and objects within each other, found more");
  }
  try {
    return json::parse(question);
  } catch (const json::parse_error& error) {
    const std::string_view what = error.what();
    const std::size_t reason = what.find("syntax error");
    throw BadQuestion("byte " + std::to_string(error.byte) + ": expected JSON, found a " +
                      std::string(reason == what.npos ? "syntax error" : what.substr(reason)));
  } catch (const json::out_of_range&) {
    throw BadQuestion("/: expected numbers that are finite as a double, found a larger one");
  }
}

void check_floats(const JsonValue& at, const json& value) {
  if (value.is_number() && !(std::fabs(value.get<double>()) <= std::numeric_limits<float>::max()))
    at.fail("a number that is finite as a float");
  if (value.is_object()) {
    for (const auto& [name, member] : value.items()) {
      check_floats(JsonValue(no_file, member, at.place() + "/" + name), member);  // any name, with zeros as well
    }
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) check_floats(at[i], value[i]);
  }
}

using Reader = void (*)(const JsonValue&, const Ray<double>&, Level, ordered_json&);
struct Kind {
  const char* name;
  Reader answer;
};
constexpr std::array<Kind, 5> kinds{{{"sphere", answer_sphere},
                                     {"torus", answer_torus},
                                     {"box", answer_box},
                                     {"mesh", answer_mesh},
                                     {"tree", answer_tree}}};

Ray<double> ray_of(const JsonValue& asked) {
  Ray<double> ray;
  ray.origin = vector_of(asked["o"]);
  ray.direction = vector_of(asked["d"]);
  if (ray.direction == Vec3d(0)) asked["d"].fail("a direction other than 0");
  return ray;
}

void answer_parsed(const json& question, Level level, ordered_json& answer) {
  const JsonValue line(no_file, question);
  const Ray<double> ray = ray_of(line["ray"]);
  const Kind* asked = nullptr;
  std::string names;
  for (const Kind& kind : kinds) {
    names += (names.empty() ? "\"" : ", \"") + std::string(kind.name) + '"';
    if (!line.find(kind.name)) continue;
    if (asked) line.fail("one shape", std::string("both \"") + asked->name + "\" and \"" + kind.name + '"');
    asked = &kind;
  }
  if (!asked) line.fail("one of the members " + names, "none");
  const JsonValue shape = line[asked->name];
  if (level == Level::fast) {
    check_floats(line["ray"], question["ray"]);
    check_floats(shape, question[asked->name]);
  }
  asked->answer(shape, ray, level, answer);
}

/// Of an error within a line, whose place has no file in front.
std::string_view without_file(std::string_view what) { return what.starts_with(":/") ? what.substr(1) : what; }

std::string to_text(const ordered_json& reply) {
  return reply.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

Answer refusal(std::size_t number, std::string_view reason, const json& question) {
  ordered_json refused;
  if (question.is_object() && question.contains("id")) refused["id"] = question["id"];
  refused["line"] = number;
  refused["error"] = reason;
  return {to_text(refused), false};
}

}  // namespace

Answer answer(std::string_view question, std::size_t number, Level level) {
  json read;
  try {
    read = parsed(question);
    ordered_json answer = ordered_json::object();
    if (read.is_object() && read.contains("id")) answer["id"] = read["id"];
    answer_parsed(read, level, answer);
    return {to_text(answer), true};
  } catch (const std::bad_alloc&) {
    return refusal(number, "/: expected a question that fits into memory, found a larger one", read);
  } catch (const std::exception& error) {
    return refusal(number, without_file(error.what()), read);
  }
}

Answer refuse_long_line(std::size_t longest, std::size_t number) {
  return refusal(number,
                 "byte " + std::to_string(longest + 1) + ": expected a line of at most " + std::to_string(longest) +
                     " bytes, found a longer one",
                 {});
}

}  // namespace sightline::probe
