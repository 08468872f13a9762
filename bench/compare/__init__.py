"""Compares pbrt-feather with Mitsuba 3 and with bare Embree; bench/run.sh starts it."""
