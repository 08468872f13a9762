# cairo >= 1.16 (LGPL-2.1 or MPL-1.1): lines and text of bsdftool's plots, target PkgConfig::cairo.
# Debian: libcairo2-dev and a font (fonts-dejavu-core).
find_package(PkgConfig REQUIRED)
pkg_check_modules(cairo REQUIRED GLOBAL IMPORTED_TARGET cairo>=1.16)
