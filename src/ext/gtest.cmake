# googletest >= 1.12 (BSD-3-Clause): unit tests. Debian: libgtest-dev, libgmock-dev.
find_package(GTest 1.12 REQUIRED)
