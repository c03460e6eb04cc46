// A yardstick: where this takes longer than before, so does all else, and the machine is to blame.
#include <benchmark/benchmark.h>

#include <cstring>
#include <vector>

namespace groundgrid::benchmarks {
namespace {

void copy_8_mb(benchmark::State& state) {
  const std::vector<char> from(std::size_t{8} << 20U, 'x');
  std::vector<char> to(from.size());
  for ([[maybe_unused]] const auto iteration : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
}

BENCHMARK(copy_8_mb)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace groundgrid::benchmarks
