// Placeholder until the run is chosen.
#include <gtest/gtest.h>
