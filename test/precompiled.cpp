// The source of the target test_precompiled, whose headers (CMakeLists.txt) all tests share.
