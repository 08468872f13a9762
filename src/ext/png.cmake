# libpng >= 1.6 (libpng-2.0): PNG pictures. Debian: libpng-dev.
find_package(PNG 1.6 REQUIRED)
