#include "pbrt/bsdftool/commands.h"
namespace pbrt::bsdftool {
Outcome RunBench(Args) { return {}; }
}
