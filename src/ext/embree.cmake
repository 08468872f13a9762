# Embree >= 3.13 (Apache-2.0): ray traversal of triangles, curves, instances and user shapes.
# Debian: libembree-dev. Embree 4 is accepted too; every call is in src/pbrt/accel.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3.13 REQUIRED)
endif()
