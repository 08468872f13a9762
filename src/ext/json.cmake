# JSON for Modern C++ >= 3.11 (MIT): presets of feathergen, statistics of pbrt. Debian: nlohmann-json3-dev.
find_package(nlohmann_json 3.11 REQUIRED)
