# Ptex >= 2.3 (BSD-3-Clause), optional: per-face textures. No package of Debian 12; where it is not
# found, src/pbrt/ptex/native reads and writes the files. Target Ptex::Ptex_dynamic or _static.
find_package(ptex QUIET)
