// A program with a data race put in on purpose: proof that the thread sanitizer's run looks at OpenMP code.
//
// Two threads of one team add to the same counter. With the argument "none" each has a counter of its own and the
// team's barrier orders the sum, which must be reported by nobody. The counts are printed so that neither loop can
// be optimised away.
#include <cstdio>
#include <string_view>
#include <vector>

#include <omp.h>

namespace {

constexpr int kThreads = 2;
constexpr int kTurns   = 10000;

long countTogether()
{
    long  total  = 0;
    long* shared = &total;
#pragma omp parallel num_threads(kThreads)
    for (int turn = 0; turn < kTurns; ++turn) *static_cast<volatile long*>(shared) = *shared + 1;  // the race
    return total;
}

long countApart()
{
    std::vector<long> counts(kThreads, 0);
#pragma omp parallel num_threads(kThreads)
    {
        const auto mine = static_cast<std::size_t>(omp_get_thread_num());
        for (int turn = 0; turn < kTurns; ++turn) ++counts[mine];
#pragma omp barrier
#pragma omp          single
        counts[0] += counts[1];
    }
    return counts[0];
}

}  // namespace

int main(int argc, char** argv)
{
    const bool race = !(argc > 1 && std::string_view(argv[1]) == "none");
    std::printf("%ld\n", race ? countTogether() : countApart());
    return 0;
}
