#include "bench/power_fit.h"

#include <cmath>
#include <stdexcept>

namespace sightline::bench {

std::optional<PowerFit> fit_power(std::span<const double> x, std::span<const double> y) {
  if (x.size() != y.size()) throw std::invalid_argument("different numbers of x and y to fit");
  const auto n = static_cast<double>(x.size());
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / n;
    mean_y += std::log(y[i]) / n;
  }
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    xx += dx * dx;
    xy += dx * (std::log(y[i]) - mean_y);
  }
  if (!(xx > 0)) return std::nullopt;
  PowerFit fit;
  fit.exponent = xy / xx;
  fit.factor = std::exp(mean_y - fit.exponent * mean_x);
  if (x.size() > 2) {
    double scatter = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double miss = std::log(y[i]) - mean_y - fit.exponent * (std::log(x[i]) - mean_x);
      scatter += miss * miss;
    }
    fit.standard_error = std::sqrt(scatter / (n - 2) / xx);
  }
  return fit;
}

}  // namespace sightline::bench
