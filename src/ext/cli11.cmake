# CLI11 >= 2.1 (BSD-3-Clause): command lines. Debian: libcli11-dev.
find_package(CLI11 2.1 REQUIRED)
