#include "bench/laws/report.h"
namespace laws {
void tangential(Report&) {}
}  // namespace laws
