# libjpeg-turbo >= 2.1 (IJG and BSD-3-Clause): JPEG textures. Debian: libjpeg-dev.
find_package(JPEG REQUIRED)
