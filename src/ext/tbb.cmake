# oneTBB >= 2021 (Apache-2.0): threads; Embree brings it. Debian: libtbb-dev.
find_package(TBB 2021 REQUIRED)
