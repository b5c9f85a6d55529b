#pragma once
/// Build options that describe themselves: their names, limits and meaning serve validation, help and command lines
/// alike.

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

namespace sightline {

/// How much time building may take for the sake of queries: an option `quality` of every structure that has a choice.
enum class Quality {
  fast,      ///< As quickly as possible: few candidates for every division.
  balanced,  ///< The default: what pays off within some million rays.
  best,      ///< As good as this library can: every candidate, spatial splits where the structure knows them.
};
inline constexpr std::array<std::string_view, 3> quality_names{"fast", "balanced", "best"};

/// One field of an options struct. A bool has the limits 0 and 1, a Quality 0 and 2.
template <class O>
struct OptionField {
  std::string_view name;
  std::variant<int O::*, float O::*, bool O::*, Quality O::*> member;
  double lowest;
  double highest;
  std::string_view help;
};

namespace detail {

inline std::string number_text(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

[[noreturn]] inline void refuse_option(std::string_view structure, std::string_view field, std::string_view value,
                                       const std::string& allowed) {
  throw std::invalid_argument(std::string(structure) + ": " + std::string(field) + " = " + std::string(value) +
                              " is not allowed; expected " + allowed);
}

template <class O>
std::string allowed_text(const OptionField<O>& field) {
  if (std::holds_alternative<bool O::*>(field.member)) return "true or false";
  if (std::holds_alternative<Quality O::*>(field.member)) return "fast, balanced or best";
  const std::string kind = std::holds_alternative<int O::*>(field.member) ? "a whole number" : "a number";
  return kind + " from " + number_text(field.lowest) + " to " + number_text(field.highest);
}

}  // namespace detail

/// \throws std::invalid_argument naming structure, field, value and what is allowed. NaN is never allowed.
template <class O>
void validate(std::string_view structure, const O& options) {
  for (const OptionField<O>& field : O::fields()) {
    const double value = std::visit([&](auto member) { return static_cast<double>(options.*member); }, field.member);
    if (!(value >= field.lowest && value <= field.highest)) {
      detail::refuse_option(structure, field.name, detail::number_text(value), detail::allowed_text(field));
    }
  }
}

/// Sets the field called `name` from text.
/// \throws std::invalid_argument when there is no such field (the message lists them) or the text is no allowed value
/// of it; the options are then as before.
template <class O>
void set_option(std::string_view structure, O& options, std::string_view name, std::string_view text) {
  std::string known;
  for (const OptionField<O>& field : O::fields()) {
    known += (known.empty() ? "" : ", ") + std::string(field.name);
    if (field.name != name) continue;
    const auto parse = [&]<class M>(M O::*member) {
      if constexpr (std::is_same_v<M, bool>) {
        if (text != "true" && text != "false")
          detail::refuse_option(structure, name, text, detail::allowed_text(field));
        options.*member = text == "true";
      } else if constexpr (std::is_same_v<M, Quality>) {
        const auto found = std::find(quality_names.begin(), quality_names.end(), text);
        if (found == quality_names.end()) detail::refuse_option(structure, name, text, detail::allowed_text(field));
        options.*member = static_cast<Quality>(found - quality_names.begin());
      } else {
        M value{};
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc{} || end != text.data() + text.size()) {
          detail::refuse_option(structure, name, text, detail::allowed_text(field));
        }
        if (!(value >= field.lowest && value <= field.highest)) {
          detail::refuse_option(structure, name, text, detail::allowed_text(field));
        }
        options.*member = value;
      }
    };
    std::visit(parse, field.member);
    return;
  }
  throw std::invalid_argument(std::string(structure) + ": no option '" + std::string(name) + "'; expected " +
                              (known.empty() ? "none" : "one of " + known));
}

}  // namespace sightline
