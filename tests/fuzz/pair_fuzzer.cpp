// The entry of a coverage-guided fuzzing engine: the first byte chooses the method and pair of kinds, the rest feeds
// the pair. A broken rule writes the case for `dem contact` to stderr and aborts. Built where the compiler has the
// engine: tests/fuzz/run_pair_fuzzer.sh
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/pair_checks.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2) return 0;
  const auto entries = static_cast<std::size_t>(contact::methods_end() - contact::methods_begin());
  const contact::MethodInfo& method = contact::methods_begin()[data[0] % entries];
  pair_fuzz::Source source(data + 1, size - 1);
  const pair_fuzz::PairCase pair = pair_fuzz::draw_pair(method, source);
  const pair_fuzz::Judgement j = pair_fuzz::judge(pair, method, source);
  if (j.broken == nullptr && !j.refused) return 0;
  std::fprintf(stderr, "%s: %s\n%s", method.name.data(), j.refused ? "refused" : j.broken,
               pair_fuzz::case_file(pair, "found").c_str());
  std::abort();
}
