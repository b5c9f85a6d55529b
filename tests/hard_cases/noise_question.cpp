#include "tests/hard_cases/noise_question.h"

#include <charconv>

#include "tests/noise/lattice_oracle.h"

namespace sightline::hard {

std::string number_text(double x) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

std::string point_text(const glm::dvec3& p) {
  return "(" + number_text(p.x) + ", " + number_text(p.y) + ", " + number_text(p.z) + ")";
}

template <class T>
void judge_noise(Tally& tally, const Noise& noise, const glm::dvec3& at, T got, double size) {
  using test::Wide;
  const std::array<Wide, 3> point{Wide(at.x), Wide(at.y), Wide(at.z)};
  const Wide truth = test::LatticeOracle<3>(noise)(point), off = abs(Wide(got) - truth);
  const Wide allowed = Wide(size) * 8 * std::numeric_limits<T>::epsilon();
  const auto nearest = truth.template convert_to<T>();
  // A NaN is neither.
  const Verdict verdict = got == nearest ? Verdict::exact : off <= allowed ? Verdict::within_bound : Verdict::wrong;
  const auto error = static_cast<double>(Wide(off / size));
  tally.add(verdict, error, [&] {
    return Example{point_text(at), number_text(static_cast<double>(truth)), number_text(static_cast<double>(got))};
  });
}

template void judge_noise(Tally&, const Noise&, const glm::dvec3&, float, double);
template void judge_noise(Tally&, const Noise&, const glm::dvec3&, double, double);

}  // namespace sightline::hard
