#include <charconv>
#include <stdexcept>

#include "labs/check/check.h"

namespace sightline::labs {
namespace {

std::string joined(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : ",") + std::to_string(number);
  return text;
}

std::vector<int> parse_numbers(std::string_view text, int count, int range) {
  std::vector<int> numbers;
  const char* at = text.data();
  const char* const end = at + text.size();
  for (int i = 0; i < count; ++i) {
    int number = 0;
    const auto [rest, error] = std::from_chars(at, end, number);
    if (error != std::errc{} || number < -range || number > range) break;
    numbers.push_back(number);
    at = rest;
    if (i + 1 < count) {
      if (at == end || *at != ',') break;
      ++at;
    }
  }
  if (at != end || numbers.size() != static_cast<std::size_t>(count)) {
    throw std::invalid_argument("expected " + std::to_string(count) + " whole numbers from " + std::to_string(-range) +
                                " to " + std::to_string(range) + " with commas between them, found '" +
                                std::string(text) + "'");
  }
  return numbers;
}

}  // namespace

std::string Case::text() const {
  std::string text = joined(head);
  for (const auto& item : items) text += "/" + joined(item);
  return text;
}

Case Recipe::parse(const std::string& text) const {
  Case at;
  std::string_view rest = text;
  const auto next = [&] {
    const std::size_t end = rest.find('/');
    const std::string_view part = rest.substr(0, end);
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end);
    return part;
  };
  at.head = parse_numbers(next(), head, range);
  while (!rest.empty()) {
    rest.remove_prefix(1);
    if (at.items.size() == static_cast<std::size_t>(most_items)) {
      throw std::invalid_argument("expected at most " + std::to_string(most_items) + " items, found more");
    }
    at.items.push_back(parse_numbers(next(), item, range));
  }
  return at;
}

}  // namespace sightline::labs
