#include "tests/hard_cases/noise_question.h"

#include "tests/noise/lattice_oracle.h"

namespace sightline::hard {

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
    return Example{vector_text(at), all_digits(static_cast<double>(truth)), all_digits(static_cast<double>(got))};
  });
}

template void judge_noise(Tally&, const Noise&, const glm::dvec3&, float, double);
template void judge_noise(Tally&, const Noise&, const glm::dvec3&, double, double);

}  // namespace sightline::hard
