# zlib >= 1.2.11 (Zlib): .gz scenes and meshes. Debian: zlib1g-dev.
find_package(ZLIB 1.2.11 REQUIRED)
