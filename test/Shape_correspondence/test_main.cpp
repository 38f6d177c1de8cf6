#define CATCH_CONFIG_MAIN // Catch2 3 has its own main()
#include <catch2/catch.hpp>
