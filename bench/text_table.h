#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "bench/estimate.h"

namespace sightline::bench {

/// Columns of text, the first to the left, the others to the right, under two lines of headings. A heading that is
/// the same as the one before it stands once, over the columns that share it.
class TextTable {
 public:
  void add_column(std::string group, std::string heading) {
    groups_.push_back(std::move(group));
    rows_[0].push_back(std::move(heading));
  }
  void add_row(std::vector<std::string> cells) { rows_.push_back(std::move(cells)); }

  std::string text() const {
    std::vector<std::size_t> widths(groups_.size(), 0);
    for (const auto& row : rows_) {
      for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string out, line;
    for (std::size_t c = 0; c < groups_.size();) {
      std::size_t width = widths[c], end = c + 1;
      for (; end < groups_.size() && groups_[end] == groups_[c]; ++end) width += gap + widths[end];
      // A group's heading may be wider than its columns: then the first of them grows.
      if (groups_[c].size() > width) widths[c] += groups_[c].size() - width, width = groups_[c].size();
      line += (c == 0 ? "" : std::string(gap, ' ')) + std::string(width - groups_[c].size(), ' ') + groups_[c];
      c = end;
    }
    out += trimmed(line);
    for (const auto& row : rows_) {
      line.clear();
      for (std::size_t c = 0; c < row.size(); ++c) {
        const std::string padding(widths[c] - row[c].size(), ' ');
        line += c == 0 ? row[c] + padding : std::string(gap, ' ') + padding + row[c];
      }
      out += trimmed(line);
    }
    return out;
  }

 private:
  static constexpr std::size_t gap = 2;
  static std::string trimmed(std::string line) {
    line.erase(line.find_last_not_of(' ') + 1);
    return line + '\n';
  }

  std::vector<std::string> groups_;
  std::vector<std::vector<std::string>> rows_{1};
};

/// "1 ray", "2 rays".
inline std::string plural(std::size_t count, const std::string& word) {
  return count_text(count) + ' ' + word + (count == 1 ? "" : "s");
}

inline std::string joined(const std::vector<std::string>& items, const std::string& between = ", ") {
  std::string text;
  for (const std::string& item : items) text += (text.empty() ? "" : between) + item;
  return text;
}

/// "0.97 to 1.1" of two digits.
inline std::string interval_text(const Estimate& value, int digits) {
  return number_text(value.low, digits) + " to " + number_text(value.high, digits);
}

inline Estimate scaled(const Estimate& value, double factor) {
  return {factor * value.median, factor * value.low, factor * value.high, value.confidence};
}

}  // namespace sightline::bench
