// adagen's runtime, the same for all robots.
// The version of adagen that these headers belong to: 10000 major + 100 minor + patch.
#pragma once

#define ADAGEN_VERSION 100
