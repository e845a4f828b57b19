// adagen's runtime, the same for all robots.
// All that a solver in loops for one process needs which keeps nothing where segments meet, for
// refinement or for certificates, and whose links have constant inertias.
#pragma once

#include "../no_channel.hpp"
#include "plain_sweeps.hpp"
