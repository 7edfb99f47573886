#include "bench/laws/report.h"
namespace laws {
void bodies(Report&) {}
}  // namespace laws
