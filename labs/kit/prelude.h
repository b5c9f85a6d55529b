#pragma once
/// Included before everything else in a student's program, and compiled beforehand, so that theirs compiles quickly.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "labs/kit/hole.h"
#include "labs/kit/service.h"
#include "labs/kit/structure_service.h"
#include "sightline/accel/accelerator.h"
#include "sightline/accel/fixed_stack.h"
#include "sightline/accel/padded_ray.h"
