// What the leak checker of the sanitizer build must overlook, because it is not ours: Fontconfig keeps what
// it read of its configuration until the program ends, and Cairo 1.16 loses 472 bytes for every group in an
// SVG (ten lines of C show it: push_group, stroke, pop_group_to_source, paint).
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\nleak:libcairo\n"; }
