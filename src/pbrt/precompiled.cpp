// The source of the target pbrt_precompiled, whose headers (CMakeLists.txt) all rooms share.
