# OpenEXR >= 3.1 and Imath (BSD-3-Clause): EXR pictures, half floats. Debian: libopenexr-dev.
find_package(Imath REQUIRED)
find_package(OpenEXR 3.1 REQUIRED)
