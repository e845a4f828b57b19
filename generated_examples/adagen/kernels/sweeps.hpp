// adagen's runtime, the same for all robots.
// What all loops are made of.
#pragma once

#include "../gravity.hpp"
#include "accelerate.hpp"
#include "blocks.hpp"
#include "factors.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "kinds.hpp"
#include "links.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "spherical.hpp"
#include "turned.hpp"
