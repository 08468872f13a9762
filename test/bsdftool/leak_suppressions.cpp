/// Read by LeakSanitizer alone. fontconfig keeps what cairo asks it for until FcFini, which a
/// library must not call for its process: one pattern per font, not one per plot.
extern "C" const char *__lsan_default_suppressions();
extern "C" const char *__lsan_default_suppressions() {
    return "leak:libfontconfig";
}
