#include "bench/laws/report.h"
namespace laws {
void adhesion(Report&) {}
}  // namespace laws
