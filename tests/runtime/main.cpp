// The tests of the runtime's headers: one program, each header group in a file of its own.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include "doctest/doctest.h"
