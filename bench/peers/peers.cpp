#include "bench/peers/peers.h"

#include <array>

#include "bench/peers/cgal.h"
#include "bench/peers/embree.h"
#include "bench/peers/vtk.h"

namespace sightline::bench {
namespace {

using Make = std::unique_ptr<Contender> (*)(int);

constexpr std::string_view found_cgal = SIGHTLINE_BENCH_CGAL_VERSION, found_vtk = SIGHTLINE_BENCH_VTK_VERSION;

template <EmbreeMode mode>
std::unique_ptr<Contender> embree(int threads) {
  return make_embree(mode, threads);
}

constexpr Make cgal() {
  if constexpr (found_cgal.empty()) {
    return nullptr;
  } else {
    return [](int) { return make_cgal(); };
  }
}

template <VtkLocator locator>
constexpr Make vtk() {
  if constexpr (found_vtk.empty()) {
    return nullptr;
  } else {
    return [](int) { return make_vtk(locator); };
  }
}

constexpr auto infos = std::to_array<PeerInfo>({
    {reference_peer, "Embree 3 as it comes: float tests that may leak between neighbours; always part of the run",
     "libembree-dev", embree<EmbreeMode::standard>},
    {"embree-high", "with RTC_BUILD_QUALITY_HIGH, which splits triangles between boxes", "libembree-dev",
     embree<EmbreeMode::high>},
    {"embree-robust", "with RTC_SCENE_FLAG_ROBUST, as watertight as ours promise to be", "libembree-dev",
     embree<EmbreeMode::robust>},
    {"cgal", "CGAL's AABB tree over triangles in double", "libcgal-dev", cgal()},
    {"vtk-static-cell", "VTK's vtkStaticCellLocator: a uniform grid", "libvtk9-dev", vtk<VtkLocator::static_cell>()},
    {"vtk-cell", "VTK's vtkCellLocator: an octree of equal depth", "libvtk9-dev", vtk<VtkLocator::cell>()},
    {"vtk-cell-tree", "VTK's vtkCellTreeLocator: a bounding interval hierarchy", "libvtk9-dev",
     vtk<VtkLocator::cell_tree>()},
    {"vtk-bsp", "VTK's vtkModifiedBSPTree: axis-aligned planes, straddlers apart", "libvtk9-dev",
     vtk<VtkLocator::bsp>()},
    {"vtk-obb", "VTK's vtkOBBTree: oriented boxes", "libvtk9-dev", vtk<VtkLocator::obb>()},
});

}  // namespace

std::span<const PeerInfo> peer_infos() { return infos; }
std::string cgal_version() { return std::string(found_cgal); }
std::string vtk_version() { return std::string(found_vtk); }

}  // namespace sightline::bench
