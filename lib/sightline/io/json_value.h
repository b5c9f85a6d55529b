#pragma once
/// JSON that is not trusted: every look at it says where it was when something else was expected.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "sightline/io/file_error.h"

namespace sightline {

/// Arrays and objects within each other, more than any document needs: what walks one calls itself as often.
inline constexpr int deepest_json = 1000;

/// Whether a document may have comments, as those of C++.
enum class JsonComments { refused, allowed };

/// The last byte of the comment that begins at a byte, or that byte itself where none does.
inline std::size_t end_of_comment(std::string_view text, std::size_t first) {
  const std::string_view start = text.substr(first, 2);
  if (start != "//" && start != "/*") return first;
  const std::size_t end = start == "//" ? text.find('\n', first) : text.find("*/", first + 2);
  return end == std::string_view::npos ? text.size() : end + (start == "/*" ? 1 : 0);
}

/// Where a text nests deeper, or its size.
inline std::size_t too_deep_at(std::string_view text, JsonComments comments = JsonComments::refused) {
  int depth = 0;
  bool is_text = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (is_text) {
      if (c == '\\') ++i;
      is_text = c != '"';
    } else if (c == '/' && comments == JsonComments::allowed) {
      i = end_of_comment(text, i);
    } else if (c == '"') {
      is_text = true;
    } else if (c == '[' || c == '{') {
      if (++depth > deepest_json) return i;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return text.size();
}

/// The number of the line in which a byte is, from 1.
inline std::size_t line_at(std::string_view text, std::size_t byte) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  return static_cast<std::size_t>(std::count(text.begin(), end, '\n')) + 1;
}

/// What stands at the byte, counted from 1, at which a parser gave up.
inline std::string found_at(std::string_view text, std::size_t byte) {
  if (byte == 0 || byte > text.size()) return "the end at byte " + std::to_string(text.size());
  const std::string_view rest = text.substr(byte - 1, 20);
  return "'" + std::string(rest.substr(0, rest.find('\n'))) + "' at byte " + std::to_string(byte);
}

/// Throws FileError with the line.
inline nlohmann::json parse_json(const std::filesystem::path& path, std::string_view text,
                                 JsonComments comments = JsonComments::refused) {
  if (const std::size_t at = too_deep_at(text, comments); at < text.size()) {
    throw FileError(path, 0, "at most " + std::to_string(deepest_json) + " arrays and objects within each other",
                    "more at byte " + std::to_string(at + 1));
  }
  try {
    return nlohmann::json::parse(text, nullptr, true, comments == JsonComments::allowed);
  } catch (const nlohmann::json::parse_error& error) {
    throw FileError(path, line_at(text, error.byte), "JSON", found_at(text, error.byte));
  } catch (const nlohmann::json::out_of_range& error) {
    std::string_view number = error.what();  // which ends with it, in quotes
    number = number.substr(std::min(number.find('\''), number.size()));
    if (number.size() > 2) number = number.substr(1, number.size() - 2);
    throw FileError(path, line_at(text, text.find(number)), "a number that a double holds", std::string(number));
  }
}

/// A value within a JSON document, with the document's file and the value's place (a JSON pointer).
class JsonValue {
 public:
  JsonValue(const std::filesystem::path& path, const nlohmann::json& json, std::string place = "")
      : path_(&path), json_(&json), place_(std::move(place)) {}

  const std::string& place() const { return place_; }
  /// The same behind the document's file.
  std::string where() const { return path_->string() + ":" + (place_.empty() ? "/" : place_); }
  bool is_array() const { return json_->is_array(); }
  bool is_object() const { return json_->is_object(); }
  bool is_text() const { return json_->is_string(); }
  bool is_number() const { return json_->is_number(); }
  const std::filesystem::path& path() const { return *path_; }

  std::optional<JsonValue> find(const char* name) const {
    if (!json_->is_object()) fail("an object");
    const auto member = json_->find(name);
    if (member == json_->end()) return std::nullopt;
    return JsonValue(*path_, *member, place_ + "/" + name);
  }
  JsonValue operator[](const char* name) const {
    if (const auto member = find(name)) return *member;
    fail(std::string("a member \"") + name + "\"", "none");
  }

  /// Calls see(name, value) for each member, by the order of their names.
  template <class See>
  void for_each_member(See&& see) const {
    if (!json_->is_object()) fail("an object");
    for (const auto& [name, member] : json_->items()) see(name, JsonValue(*path_, member, place_ + "/" + name));
  }

  std::size_t size() const {
    if (!json_->is_array()) fail("an array");
    return json_->size();
  }
  JsonValue operator[](std::size_t i) const {
    if (i >= size()) fail("at least " + std::to_string(i + 1) + " elements", std::to_string(size()));
    return {*path_, (*json_)[i], place_ + "/" + std::to_string(i)};
  }

  /// A whole number that a double holds exactly, as the limit of JSON's numbers is in practice.
  std::uint64_t whole() const {
    constexpr double limit = 0x1p53;
    if (!json_->is_number() || !(json_->get<double>() >= 0) || !(json_->get<double>() < limit) ||
        json_->get<double>() != static_cast<double>(static_cast<std::uint64_t>(json_->get<double>()))) {
      fail("a whole number");
    }
    return static_cast<std::uint64_t>(json_->get<double>());
  }
  std::uint64_t whole_or(const char* name, std::uint64_t otherwise) const {
    const auto member = find(name);
    return member ? member->whole() : otherwise;
  }
  float number() const {
    if (!json_->is_number()) fail("a number");
    const auto value = static_cast<float>(json_->get<double>());
    if (!(value - value == 0)) fail("a number that is finite as a float");
    return value;
  }
  double real() const {
    if (!json_->is_number()) fail("a number");
    return json_->get<double>();  // JSON has no others than finite ones
  }
  /// A number from `lowest` to `highest`.
  double real_within(double lowest, double highest) const {
    const double value = real();
    if (!(value >= lowest && value <= highest)) {
      const auto said = [](double x) { return nlohmann::json(x).dump(); };
      fail("a number " + (highest < std::numeric_limits<double>::infinity()
                              ? "from " + said(lowest) + " to " + said(highest)
                              : "of at least " + said(lowest)));
    }
    return value;
  }
  bool truth() const {
    if (!json_->is_boolean()) fail("true or false");
    return json_->get<bool>();
  }
  const std::string& text() const {
    if (!json_->is_string()) fail("a string");
    return json_->get_ref<const std::string&>();
  }

  [[noreturn]] void fail(const std::string& expected) const {
    fail(expected, json_->dump(-1, ' ', true, nlohmann::json::error_handler_t::replace).substr(0, 40));
  }
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const {
    throw FileError(where(), 0, expected, found);
  }

 private:
  const std::filesystem::path* path_;
  const nlohmann::json* json_;
  std::string place_;
};

}  // namespace sightline
