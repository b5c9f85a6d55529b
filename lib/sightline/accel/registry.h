#pragma once
/// Every structure, in the order in which they are shown. Adding one is its file and its line here: tests, benchmarks,
/// drawing and help follow this list.

#include "sightline/accel/bounding_interval_hierarchy.h"
#include "sightline/accel/bounding_volume_tree.h"
#include "sightline/accel/brute_force.h"
#include "sightline/accel/bsp_tree.h"
#include "sightline/accel/kd_tree.h"
#include "sightline/accel/type_list.h"
#include "sightline/accel/uniform_grid.h"
#include "sightline/accel/wide_tree.h"

namespace sightline {

using Accelerators = TypeList<  //
    BruteForce,                 //
    SphereTree,                 //
    BoxTree,                    //
    CylinderTree,               //
    WideTree,                   //
    UniformGrid,                //
    BspTree,                    //
    KdTree,                     //
    BoundingIntervalHierarchy>;

}  // namespace sightline
