#pragma once
/// The libraries beside which ours are measured.

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "bench/contender.h"

namespace sightline::bench {

struct PeerInfo {
  std::string_view name;
  std::string_view description;
  std::string_view package;  ///< Of Debian, that a build needs to have it.
  /// Builds with so many threads, 0 for all, where the library lets one say. Null when this build is without the
  /// library.
  std::unique_ptr<Contender> (*make)(int threads);
};

/// The peer that ratios refer to; part of every build.
inline constexpr std::string_view reference_peer = "embree";

/// All that there are, in the order of help texts and tables.
std::span<const PeerInfo> peer_infos();

/// Of the libraries in this build, such as "5.5.1"; empty when it is without.
std::string cgal_version();
std::string vtk_version();

}  // namespace sightline::bench
