#include "bench/laws/report.h"
namespace laws {
void plastic(Report&) {}
}  // namespace laws
