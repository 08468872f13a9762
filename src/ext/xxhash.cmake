# xxHash >= 0.8 (BSD-2-Clause): digests of scenes, checksums of checkpoints. Debian: libxxhash-dev.
find_path(XXHASH_INCLUDE_DIR xxhash.h REQUIRED)
find_library(XXHASH_LIBRARY xxhash REQUIRED)
add_library(xxHash::xxHash UNKNOWN IMPORTED GLOBAL)
set_target_properties(xxHash::xxHash PROPERTIES IMPORTED_LOCATION ${XXHASH_LIBRARY}
                                                INTERFACE_INCLUDE_DIRECTORIES ${XXHASH_INCLUDE_DIR})
